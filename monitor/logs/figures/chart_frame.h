// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>
#include <string>
#include <vector>

#include "core/cut_text.h"
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
    // The range of numbers near the largest is infinite; that of their halves is not.
    const double part = std::isfinite(values.most - values.least) ? 1 : 0.5;
    const double range = part * values.most - part * values.least;
    return range > 0 ? (part * value - part * values.least) / range : 0.5;
  }
};

/// Returns a number with five digits, or with as many as so many letters have room for, but two.
[[nodiscard]] inline std::string fitting_text(double number, std::size_t letters) {
  std::string text = short_text(number);
  for (int digits = 4; digits >= 2 && text.size() > letters; --digits) {
    std::array<char, 32> shorter{};
    std::snprintf(shorter.data(), shorter.size(), "%.*g", digits, number);
    text = shorter.data();
  }
  return text;
}

/// Returns the last part of a name, as much of it as `width` letters have room for.
[[nodiscard]] inline std::string label_of(const std::string& name, std::size_t width) {
  return std::string(cut_text(visible(name.substr(name.rfind('.') + 1)), width));
}

}  // namespace galilean::logs
