// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "monitor/top/screen/canvas.h"

namespace galilean::monitor::top {

/// What lies over the lower part of the screen: the help, a push, a list.
struct Sheet {
  struct Line {
    std::string text;
    Style style = Style::kPlain;
  };
  std::string title;
  std::vector<Line> lines;
  std::string keys;  ///< what can be pressed
  int scroll = 0;
  std::optional<std::size_t> chosen = {};  ///< of a list: the line that the keys act on
  std::string notice = {};                 ///< stands above the keys; empty: nothing does
};

/// Draws a sheet over the screen's lower part. Puts `sheet.scroll` right, so that the chosen line
/// shows.
void lay_over(Sheet& sheet, Canvas& canvas);

}  // namespace galilean::monitor::top
