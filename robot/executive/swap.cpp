// SPDX-License-Identifier: BSD-3-Clause
#include "robot/executive/swap.h"

#include <algorithm>
#include <optional>
#include <utility>

namespace galilean::robot {
namespace {

/// Returns the index of the first variable of this type in the description, whose variables stand
/// in the order of the store, type by type.
template <class T>
std::size_t first_index(const RunningProgram& program) noexcept {
  const auto& labels = program.description->variables;
  const auto first =
      std::ranges::find(labels, std::string_view(variable_type_name<T>()),
                        [](const auto& label) { return std::string_view(label.type); });
  return static_cast<std::size_t>(first - labels.begin());
}

template <class T>
void hand_over(Variable<T>& from, Variable<T>& to) noexcept {
  to.value = from.value;
}

// The pixels are swapped, because copying them costs more than a tick. A rollback to `from` has no
// use for an old picture.
void hand_over(Variable<Image>& from, Variable<Image>& to) noexcept {
  std::swap(from.value, to.value);
  from.reliability.valid = false;
}

template <class T>
void keep(Variable<T>& from, Variable<T>& to, Time now) noexcept {
  const double decay_per_s = to.reliability.decay_per_s;
  const bool fades_alike =
      from.constant == to.constant && from.reliability.decay_per_s == decay_per_s;
  to.written_tick = from.written_tick;
  to.reliability = from.reliability;
  if (!fades_alike) to.reliability = {from.valid_at(now), from.certainty_at(now), decay_per_s, now};
  hand_over(from, to);
}

template <class T>
void carry_type(RunningProgram& from, RunningProgram& to, Time now) noexcept {
  auto& old_variables = from.variables.template all<T>();
  auto& new_variables = to.variables.template all<T>();
  const std::size_t old_first = first_index<T>(from);
  const std::size_t new_first = first_index<T>(to);
  for (std::size_t n = 0; n < new_variables.size(); ++n)
    for (std::size_t o = 0; o < old_variables.size(); ++o) {
      if (old_variables[o].name != new_variables[n].name) continue;
      const bool parameter_of_both = from.description->variables[old_first + o].parameter &&
                                     to.description->variables[new_first + n].parameter;
      if (!parameter_of_both) keep(old_variables[o], new_variables[n], now);
    }
}

std::optional<std::uint32_t> find_state(const RunningProgram& program,
                                        std::string_view name) noexcept {
  const auto& states = program.text().states;
  for (std::uint32_t i = 0; i < states.size(); ++i)
    if (states[i].name == name) return i;
  return std::nullopt;
}

}  // namespace

void carry_over(RunningProgram& from, RunningProgram& to, Time now) noexcept {
  carry_type<Shaft>(from, to, now);
  carry_type<Image>(from, to, now);
  carry_type<Locate>(from, to, now);
  carry_type<Bits>(from, to, now);
  carry_type<Force>(from, to, now);
}

std::uint32_t successor_state(const RunningProgram& from, const RunningProgram& to) noexcept {
  return successor_state(from.state_name(), to);
}

std::uint32_t successor_state(const std::string& left, const RunningProgram& to) noexcept {
  if (const auto same = find_state(to, left)) return *same;
  if (const auto mapped = to.text().on_swap.find(left); mapped != to.text().on_swap.end())
    if (const auto target = find_state(to, mapped->second)) return *target;
  return to.state;
}

}  // namespace galilean::robot
