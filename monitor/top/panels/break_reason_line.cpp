// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/top/panels/break_sign.h"
#include "monitor/top/panels/panels.h"
#include "monitor/top/screen/utf8.h"

namespace galilean::monitor::top {

bool draw_break_reason(const View& view, const Area& area, Canvas& canvas) {
  const ShownRobot& robot = view.robots[view.chosen];
  if (robot.status.break_reason.empty()) return false;
  const BreakMark mark = robot.is_stopped ? BreakMark::kStop
                         : robot.waits    ? BreakMark::kLock
                                          : BreakMark::kNone;
  const std::string text =
      sign_of(mark) + (" " + robot.status.name + ": ") + robot.status.break_reason;
  const int end = canvas.put(area.row, area.column, text, Style::kWarning, area.columns);
  // In the past the robot may stand no longer, and keys act on the present.
  const std::string keys = view.is_past        ? ""
                           : robot.is_stopped  ? "n step  r go on"
                           : robot.waits       ? "B let through"
                           : robot.status.held ? "r go on"
                                               : "";
  if (area.column + area.columns - end > width_of(keys))
    canvas.put_right(area.row, area.column + area.columns, keys, Style::kBold);
  return true;
}

}  // namespace galilean::monitor::top
