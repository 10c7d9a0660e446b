// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "core/clock.h"
#include "monitor/team/robot.h"

namespace galilean::monitor {

/// Returns whether the condition of a locked transition holds, so that the robot waits for an
/// operator.
[[nodiscard]] bool waits_at_lock(const msg::Breaks& breaks) noexcept;
/// Returns for how many seconds a robot has waited at a lock. `since_told` is the time since
/// `breaks` came. Requires: waits_at_lock(breaks).
[[nodiscard]] double lock_wait_s(const msg::Breaks& breaks, Duration since_told) noexcept;

/// Returns what stopped a robot: "break point wander -> grab", "a step", "io's break point on
/// entering grab". Returns an empty text if neither a break point nor a step did.
[[nodiscard]] std::string stopper_words(const msg::Breaks& breaks);
/// Returns in a few words why the robot stands still or what it waits for: "stopped at wander ->
/// grab (Anna's break point)", "stepped into grab", "waits at the lock grab -> move for 3 s",
/// "held: the serial line was gone for 3.2 s; …". Returns an empty string if no break point, step,
/// lock or fault keeps it. `since_told` is the time since the robot's breaks came.
[[nodiscard]] std::string break_reason(const Robot& robot, Duration since_told);

}  // namespace galilean::monitor
