// SPDX-License-Identifier: BSD-3-Clause
#include "robot/executive/sequencer.h"

#include <algorithm>

namespace galilean::robot {
namespace {

void update_bit(const RunningCondition& condition) noexcept {
  Bits& bits = condition.bits->value;
  switch (condition.bit_update) {
    case bhdl::BitUpdate::kSame:
      return;
    case bhdl::BitUpdate::kSet:
      return bits.assign(condition.bit_index, true);
    case bhdl::BitUpdate::kClear:
      return bits.assign(condition.bit_index, false);
    case bhdl::BitUpdate::kToggle:
      return bits.assign(condition.bit_index, !condition.bit_value);
  }
}

}  // namespace

bool holds(const RunningCondition& condition, Time now) noexcept {
  return condition.bits->valid_at(now) &&
         condition.bits->value.test(condition.bit_index) == condition.bit_value;
}

ConditionSnapshot test_all(const RunningState& state, Time now) noexcept {
  ConditionSnapshot tested;
  const auto count = std::min<std::size_t>(state.conditions.size(), ConditionSnapshot::kMost);
  for (std::size_t i = 0; i < count; ++i) {
    const RunningCondition& condition = state.conditions[i];
    tested.valid |= std::uint64_t{condition.bits->valid_at(now)} << i;
    tested.holds |= std::uint64_t{holds(condition, now)} << i;
  }
  return tested;
}

void fire(const RunningCondition& condition, Time now) noexcept {
  update_bit(condition);
  for (const VariableRef& variable : condition.reset_variables) reset(variable, now);
}

}  // namespace galilean::robot
