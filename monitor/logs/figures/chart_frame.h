// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <limits>
#include <string>
#include <vector>

#include "core/visible_text.h"
#include "monitor/logs/figures/chart.h"

namespace galilean::logs {

/// The frame that all is drawn in.
struct ChartFrame {
  double from_s = std::numeric_limits<double>::infinity(), to_s = -from_s;
  ValueRange values;

  ChartFrame(const std::vector<NamedSeries>& all, const std::vector<NamedBars>& bars) {
    for (const auto& each : all) {
      include(each.series.first_s(), each.series.last_s());
      values.take(each.series.range());
    }
    for (const auto& each : bars) include(each.bars.first_s(), each.bars.last_s());
  }
  void include(double first_s, double last_s) {
    from_s = std::min(from_s, first_s);
    to_s = std::max(to_s, last_s);
  }
  /// Returns where a value is: 0 at the bottom, 1 on top; in the middle if all are one.
  [[nodiscard]] double height_of(double value) const {
    const double range = values.most - values.least;
    return range > 0 ? (value - values.least) / range : 0.5;
  }
};

/// Returns the last part of a name, as much of it as `width` letters have room for.
[[nodiscard]] inline std::string label_of(const std::string& name, std::size_t width) {
  return visible(name.substr(name.rfind('.') + 1)).substr(0, width);
}

}  // namespace galilean::logs
