// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "monitor/top/model/view.h"
#include "monitor/top/screen/canvas.h"

namespace galilean::monitor::top {

/// Returns the whole dashboard for a screen of this size. Screens of at least 80 × 24 cells show
/// all that is essential.
[[nodiscard]] Canvas lay_out(const View& view, int columns, int rows);
/// Returns the help page, which explains the keys.
[[nodiscard]] Canvas lay_out_help(int columns, int rows);

}  // namespace galilean::monitor::top
