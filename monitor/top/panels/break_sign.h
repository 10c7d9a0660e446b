// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "monitor/top/model/view.h"
#include "monitor/top/screen/canvas.h"

namespace galilean::monitor::top {

/// Returns the sign of a break point: a dot where robots stop, a square where they wait.
[[nodiscard]] constexpr const char* sign_of(BreakMark mark) noexcept {
  return mark == BreakMark::kNone ? " " : mark == BreakMark::kLock ? "■" : "●";
}
/// Returns how the sign looks: one that stops the team is as loud as an alarm.
[[nodiscard]] constexpr Style style_of(BreakMark mark) noexcept {
  return mark == BreakMark::kStopTeam ? Style::kAlarm : Style::kWarning;
}

}  // namespace galilean::monitor::top
