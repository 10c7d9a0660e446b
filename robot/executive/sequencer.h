// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>

#include "robot/executive/event.h"
#include "robot/executive/running_program.h"

namespace galilean::robot {

/// Returns whether the condition's variable is valid at `now` and its bit has the value asked for.
[[nodiscard]] bool holds(const RunningCondition& condition, Time now) noexcept;

/// Returns the index of the first condition, in the order of the text, that holds at `now` and that
/// `may_fire(index)` lets fire, or nothing. `may_fire` is asked about conditions that hold alone.
template <class MayFire>
[[nodiscard]] std::optional<std::uint32_t> first_that_fires(const RunningState& state, Time now,
                                                            MayFire may_fire) noexcept {
  for (std::uint32_t i = 0; i < state.conditions.size(); ++i)
    if (holds(state.conditions[i], now) && may_fire(i)) return i;
  return std::nullopt;
}

/// Tests every condition of the state at `now`. Conditions beyond ConditionSnapshot::kMost are left
/// out.
[[nodiscard]] ConditionSnapshot test_all(const RunningState& state, Time now) noexcept;

/// Does what a condition does when it fires, besides changing the state. It writes the tested bit
/// as `bit_update` says, and keeps the certainty. Then it makes its reset_variables invalid.
void fire(const RunningCondition& condition, Time now) noexcept;

}  // namespace galilean::robot
