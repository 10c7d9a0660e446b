// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>

#include "robot/executive/event.h"
#include "robot/executive/running_program.h"

namespace galilean::robot {

/// Index of the first condition, in the order of the text, that holds at `now`: its bit has the
/// value asked for and its variable is valid. On an invalid variable none ever holds.
[[nodiscard]] std::optional<std::uint32_t> first_that_holds(const RunningState& state,
                                                            Time now) noexcept;

/// Every condition of the state as it is at `now`.
[[nodiscard]] TestedConditions test_all(const RunningState& state, Time now) noexcept;

/// What a condition does when it fires, besides changing the state: it writes the tested bit as
/// `bit_update` says (its certainty stays), then makes its reset_variables invalid.
void fire(const RunningCondition& condition, Time now) noexcept;

}  // namespace galilean::robot
