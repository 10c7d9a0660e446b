// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/top/panels/layout.h"

#include <algorithm>
#include <array>

#include "monitor/top/panels/panels.h"

namespace galilean::monitor::top {
namespace {

constexpr const char* kKeys =
    "↑↓ 1-9 choose  h hold  r resume  s start  (H R S: all)  ? help  q quit";

void draw_footer(const View& view, Canvas& canvas) {
  const int row = canvas.rows() - 1;
  if (view.notice.empty())
    canvas.put(row, 0, kKeys, Style::kDim);
  else
    canvas.put(row, 0, view.notice, Style::kBold);
}

/// Draws the map on the left, and on the right the chosen robot's states above its variables.
void draw_lower(const View& view, const Area& area, Canvas& canvas) {
  constexpr int kGap = 2;
  const int left = area.columns * 2 / 5;
  draw_map(view, {area.row, area.column, area.rows, left}, canvas);
  const int column = area.column + left + kGap, columns = area.columns - left - kGap;
  // The states get the rows that the variables do not need.
  const int left_over = area.rows - 1 - static_cast<int>(view.variables.size());
  const int states = std::min(static_cast<int>(view.states.size()) + 1,
                              std::max({4, area.rows * 2 / 5, left_over}));
  draw_states(view, {area.row, column, states, columns}, canvas);
  draw_variables(view, {area.row + states, column, area.rows - states, columns}, canvas);
}

}  // namespace

Canvas lay_out(const View& view, int columns, int rows) {
  Canvas canvas(columns, rows);
  draw_title(view, canvas);
  draw_footer(view, canvas);
  if (view.robots.empty()) {
    canvas.put(2, 0, "No robot has been heard yet.");
    canvas.put(3, 0, "Check that robots run in the same DDS domain (--domain or ROS_DOMAIN_ID).");
    return canvas;
  }
  const int most_robots = std::max(3, rows / 3);
  int row = 1 + draw_team(view, {1, 0, most_robots, columns}, canvas);
  row += draw_problems(view, {row, 0, 2, columns}, canvas);
  draw_lower(view, {row, 0, rows - 1 - row, columns}, canvas);
  return canvas;
}

Canvas lay_out_help(int columns, int rows) {
  Canvas canvas(columns, rows);
  static constexpr std::array kLines{
      "↑ ↓, 1-9   choose a robot: its states and variables are shown",
      "h, H       hold: the robot chosen, or all, stand still until resumed",
      "r, R       resume",
      "s, S       start: push a bumper, which is what the start state waits for",
      "q, Ctrl-C  quit; the robots go on",
      "",
      "A grey robot has not been heard for 2 s; its age is in the table.",
      "A bar is a variable's certainty now; it decays until a schema writes it again.",
      "LEAST SURE: the valid variable that the robot is least certain of.",
      "TICK: the longest time lately that a control tick took, in microseconds.",
      "",
      "q quits here, too; any other key goes back."};
  canvas.put(0, 0, "Keys", Style::kBold);
  for (std::size_t i = 0; i < kLines.size(); ++i) canvas.put(static_cast<int>(i) + 2, 2, kLines[i]);
  return canvas;
}

}  // namespace galilean::monitor::top
