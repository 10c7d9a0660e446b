// SPDX-License-Identifier: BSD-3-Clause
#include "bhdl/lint/bit_flow.h"

#include <algorithm>

#include "bhdl/program/initial_value.h"

namespace galilean::bhdl {
namespace {

constexpr BitValues kValid = kBitZero | kBitOne;
constexpr BitValues kAnything = kValid | kBitInvalid;
constexpr int kInvalidShift = 2;

BitValues made_invalid(BitValues values) noexcept {
  return static_cast<BitValues>((values & kBitInvalid) | (values & kValid) << kInvalidShift);
}
BitValues made_valid(BitValues values) noexcept {
  return static_cast<BitValues>((values & kValid) | values >> kInvalidShift);
}

BitValues updated(const Condition& condition) noexcept {
  switch (condition.bit_update) {
    case BitUpdate::kSet:
      return kBitOne;
    case BitUpdate::kClear:
      return kBitZero;
    case BitUpdate::kToggle:
      return bit_values_of(!condition.bit_value);
    default:
      return bit_values_of(condition.bit_value);
  }
}

void note_writes(const SchemaUse& use, std::size_t state, WritersOfTested& writers) {
  for (const auto& written : use.written)
    if (const auto found = writers.find(written.variable); found != writers.end())
      found->second.in_state[state] |= written.bits;
}

void note_fading(const SchemaUse& use, WritersOfTested& writers) {
  for (const auto* variables : {&use.writes, &use.updates, &use.adjusts})
    for (const std::size_t variable : *variables)
      if (const auto found = writers.find(variable); found != writers.end())
        found->second.fades = true;
}

}  // namespace

WritersOfTested writers_of_tested(const Program& program, const SchemaUses& uses,
                                  std::span<const std::size_t> tested) {
  WritersOfTested writers;
  for (const std::size_t variable : tested)
    writers[variable].in_state.resize(program.states.size());
  for (std::size_t i = 0; i < program.states.size(); ++i) {
    for (const auto* use : uses.listed(i).perceptual) note_writes(*use, i, writers);
    for (const auto* use : uses.listed(i).motor) note_writes(*use, i, writers);
  }
  for (const auto& use : uses.all()) note_fading(use, writers);
  return writers;
}

BitFlow::BitFlow(const Program& program, const StateGraph& graph, const VariableWriters& writers,
                 const TestedBit& bit)
    : program_(program), writers_(writers), bit_(bit), entered_(program.states.size(), 0) {
  enter(graph.index(program.start_state), initial());
  for (const auto& [old_state, new_state] : program.on_swap)
    enter(graph.index(new_state), changes() ? kAnything : initial());
  while (!to_visit_.empty()) {
    const std::size_t state = to_visit_.back();
    to_visit_.pop_back();
    const auto& conditions = program.states[state].conditions;
    for (std::size_t i = 0; i < conditions.size(); ++i)
      enter(graph.targets(state)[i], behind(conditions[i], within(state)));
  }
}

BitValues BitFlow::within(std::size_t state) const noexcept {
  BitValues values = entered_[state];
  if (values == 0) return values;
  const std::uint32_t written = writers_.in_state[state];
  if (written != 0) values |= made_valid(values);
  if ((written >> bit_.index & 1U) != 0) values |= kValid;
  if (writers_.fades) values |= made_invalid(values);
  return values;
}

bool BitFlow::changes() const {
  const auto writes = [this](std::uint32_t bits) { return (bits >> bit_.index & 1U) != 0; };
  if (std::ranges::any_of(writers_.in_state, writes)) return true;
  const auto updates = [this](const Condition& each) {
    return each.bit_update != BitUpdate::kSame && each.bits_variable == bit_.variable &&
           each.bit_index == bit_.index;
  };
  return std::ranges::any_of(program_.states, [&](const State& state) {
    return std::ranges::any_of(state.conditions, updates);
  });
}

BitValues BitFlow::initial() const {
  const auto found = std::ranges::find(program_.variables, bit_.variable, &Component::name);
  if (found == program_.variables.end()) return kAnything;
  const auto value = initial_bits(*found);
  if (!value) return kAnything;
  const BitValues held = bit_values_of((*value >> bit_.index & 1U) != 0);
  return starts_valid(*found) ? held : made_invalid(held);
}

BitValues BitFlow::behind(const Condition& condition, BitValues values) const {
  if (condition.bits_variable == bit_.variable) {
    const bool same = condition.bit_index == bit_.index;
    const BitValues seen = same ? bit_values_of(condition.bit_value) : kValid;
    if ((values & seen) == 0) return 0;
    values = same ? updated(condition) : static_cast<BitValues>(values & seen);
  }
  const auto& reset = condition.reset_variables;
  return std::ranges::find(reset, bit_.variable) != reset.end() ? made_invalid(values) : values;
}

void BitFlow::enter(std::size_t state, BitValues values) {
  const auto more = static_cast<BitValues>(entered_[state] | values);
  if (more == entered_[state]) return;
  entered_[state] = more;
  to_visit_.push_back(state);
}

}  // namespace galilean::bhdl
