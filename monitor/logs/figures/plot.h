// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "monitor/logs/pictures/picture_files.h"
#include "monitor/logs/reading/selection.h"

namespace galilean::logs {

/// What `galilean log plot` is asked for.
struct PlotOptions {
  std::string file;
  std::vector<std::string> values;  ///< TOPIC.FIELD, such as "io/state.x_m"; none with `map`
  bool map = false;                 ///< robots' tracks over the floor are drawn, and no fields
  double from_s = 0;
  std::optional<double> to_s;
  int width = 72, height = 16;  ///< of the drawing [letters]
  PictureFiles pictures;        ///< to write; without any it is drawn as text
};

/// Draws fields over time: numbers as curves, and texts, such as states, as bars; or robots'
/// tracks. Returns the exit code.
[[nodiscard]] int plot(const PlotOptions& options);

}  // namespace galilean::logs
