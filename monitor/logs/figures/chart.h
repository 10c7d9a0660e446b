// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "monitor/logs/figures/series.h"

namespace galilean::logs {

/// A series with the name that a legend shows.
struct NamedSeries {
  std::string name;
  Series series;
};

/// Returns the series drawn with letters, over one axis of time. Each column shows the range of the
/// values in its time. Requires: there is a series, and each has a value; `width` and `height` are
/// at least 10 and 3.
[[nodiscard]] std::string chart_text(const std::vector<NamedSeries>& all, std::size_t width,
                                     std::size_t height);
/// Returns the same as an SVG picture.
[[nodiscard]] std::string chart_svg(const std::vector<NamedSeries>& all);

}  // namespace galilean::logs
