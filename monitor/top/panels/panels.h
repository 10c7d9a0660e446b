// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "monitor/top/model/view.h"
#include "monitor/top/screen/canvas.h"

namespace galilean::monitor::top {

// Each function draws one part of the dashboard, and only into its area.

/// Draws the number of robots and the score in the first line.
void draw_title(const View& view, Canvas& canvas);
/// Draws a heading and a line for each robot. A last line counts the robots that do not fit.
/// Returns the number of rows used. `first` becomes the index of the first robot that is drawn.
int draw_team(const View& view, const Area& area, std::size_t& first, Canvas& canvas);
/// Draws the alarms, one in a line, or one kind in a line if there are more than fit. Returns
/// those that are drawn, one a row.
[[nodiscard]] std::vector<AlarmLine> draw_alarms(const View& view, const Area& area,
                                                 Canvas& canvas);
/// Draws why the chosen robot stands at a break point, or what it waits for, and the keys for it.
/// Returns false if there is nothing to tell.
[[nodiscard]] bool draw_break_reason(const View& view, const Area& area, Canvas& canvas);
/// Draws the occupancy grid, objects and robots from above, with the map's y axis up.
void draw_map(const View& view, const Area& area, Canvas& canvas);

// The following scroll: `scroll` is the number of lines above the first one that is drawn. It is
// put right where there are not so many lines.

/// Draws the states of the chosen robot's program with the conditions that lead out of the present
/// one, and the signs of break points. The chosen state, or else the present one, shows if `scroll`
/// is 0. Returns the state in each row below the heading; an empty name for a condition.
[[nodiscard]] std::vector<std::string> draw_machine(const View& view, const Area& area, int& scroll,
                                                    Canvas& canvas);
/// Draws the chosen robot's variables, each with a bar of its certainty and the curve of its recent
/// values.
void draw_variables(const View& view, const Area& area, int& scroll, Canvas& canvas);
/// Draws the last changes of the chosen robot's state, with their reasons.
void draw_why(const View& view, const Area& area, int& scroll, Canvas& canvas);

/// Returns the number of lines that draw_machine draws if there is room.
[[nodiscard]] int machine_lines(const View& view);

/// Draws a heading with a remark at the right, if there is room for both.
void draw_panel_heading(const std::string& heading, const std::string& remark, const Area& area,
                        Canvas& canvas);
/// Returns `scroll` within what `count` lines in `room` rows allow.
[[nodiscard]] int clamped_scroll(int scroll, int count, int room) noexcept;

}  // namespace galilean::monitor::top
