// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "monitor/top/screen/canvas.h"
#include "monitor/top/screen/palette.h"

namespace galilean::monitor::top {

/// Returns the bytes that make a terminal that shows `before` show `now`. Only the cells that
/// differ are sent. Without `before`, or if its size is another, the screen is cleared first.
[[nodiscard]] std::string changes(const Canvas* before, const Canvas& now, const Look& look);

/// Returns the ASCII character that looks most like a character of the dashboard.
[[nodiscard]] char ascii_for(char32_t glyph) noexcept;

}  // namespace galilean::monitor::top
