// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "monitor/top/canvas.h"
#include "monitor/top/view.h"

namespace galilean::monitor::top {

/// The whole dashboard on a screen of this size; from 80 × 24 on nothing essential is left out.
[[nodiscard]] Canvas lay_out(const View& view, int columns, int rows);
/// What the keys do.
[[nodiscard]] Canvas lay_out_help(int columns, int rows);

}  // namespace galilean::monitor::top
