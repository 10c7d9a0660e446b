// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "monitor/logs/figures/series.h"
#include "monitor/logs/figures/state_bars.h"
#include "monitor/logs/pictures/drawing.h"

namespace galilean::logs {

/// A series with the name that a legend shows.
struct NamedSeries {
  std::string name;
  Series series;
};

/// Texts over time, with the name that a legend shows.
struct NamedBars {
  std::string name;
  StateBars bars;
};

/// Returns the series drawn with letters, and the texts as bars of letters, over one axis of time.
/// Each column shows the range of the values in its time. Requires: there is a series or a bar, and
/// each has a value; `width` and `height` are at least 10 and 3.
[[nodiscard]] std::string chart_text(const std::vector<NamedSeries>& all, std::size_t width,
                                     std::size_t height, const std::vector<NamedBars>& bars = {});
/// Returns the same as a picture.
[[nodiscard]] Drawing chart_drawing(const std::vector<NamedSeries>& all,
                                    const std::vector<NamedBars>& bars = {});

}  // namespace galilean::logs
