// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "monitor/top/canvas.h"
#include "monitor/top/view.h"

namespace galilean::monitor::top {

// Each draws one part of the dashboard into its area and leaves the rest alone.

/// Scenario, clock, pieces and points; in one line.
void draw_title(const View& view, Canvas& canvas);
/// A line for each robot under a heading; a last line counts those that do not fit. Returns the
/// number of rows used.
int draw_team(const View& view, const Area& area, Canvas& canvas);
/// The problems of the chosen robot, a line each. Returns the number of rows used.
int draw_problems(const View& view, const Area& area, Canvas& canvas);
/// Floor, objects and robots from above, north up.
void draw_map(const View& view, const Area& area, Canvas& canvas);
/// The states of the chosen robot's program, the current one marked; scrolled so that it shows.
void draw_states(const View& view, const Area& area, Canvas& canvas);
/// Its variables with a bar of certainty each.
void draw_variables(const View& view, const Area& area, Canvas& canvas);

}  // namespace galilean::monitor::top
