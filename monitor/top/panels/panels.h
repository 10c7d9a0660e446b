// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "monitor/top/model/view.h"
#include "monitor/top/screen/canvas.h"

namespace galilean::monitor::top {

// Each function draws one part of the dashboard, and only into its area.

/// Draws the number of robots and the score in the first line.
void draw_title(const View& view, Canvas& canvas);
/// Draws a heading and a line for each robot. A last line counts the robots that do not fit.
/// Returns the number of rows used.
int draw_team(const View& view, const Area& area, Canvas& canvas);
/// Draws the chosen robot's problems, one in a line. Returns the number of rows used.
int draw_problems(const View& view, const Area& area, Canvas& canvas);
/// Draws the occupancy grid, objects and robots from above, with the map's y axis up.
void draw_map(const View& view, const Area& area, Canvas& canvas);
/// Draws the states of the chosen robot's program, scrolled so that the current one shows.
void draw_states(const View& view, const Area& area, Canvas& canvas);
/// Draws the chosen robot's variables, each with a bar of its certainty.
void draw_variables(const View& view, const Area& area, Canvas& canvas);

}  // namespace galilean::monitor::top
