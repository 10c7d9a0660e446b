// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>

#include "robot/executive/event.h"
#include "robot/executive/running_program.h"

namespace galilean::robot {

/// Returns the index of the first condition, in the order of the text, that holds at `now`, or
/// nothing. A condition holds if its variable is valid and its bit has the value asked for.
[[nodiscard]] std::optional<std::uint32_t> first_that_holds(const RunningState& state,
                                                            Time now) noexcept;

/// Tests every condition of the state at `now`. Conditions beyond ConditionSnapshot::kMost are left
/// out.
[[nodiscard]] ConditionSnapshot test_all(const RunningState& state, Time now) noexcept;

/// Does what a condition does when it fires, besides changing the state. It writes the tested bit
/// as `bit_update` says, and keeps the certainty. Then it makes its reset_variables invalid.
void fire(const RunningCondition& condition, Time now) noexcept;

}  // namespace galilean::robot
