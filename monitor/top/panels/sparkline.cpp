// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/top/panels/sparkline.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "monitor/top/panels/whole_number.h"

namespace galilean::monitor::top {

std::string sparkline(const std::vector<double>& numbers, int width) {
  static constexpr std::array kBlocks{"▁", "▂", "▃", "▄", "▅", "▆", "▇", "█"};
  constexpr int kSteps = kBlocks.size() - 1;
  const auto shown = std::min(numbers.size(), static_cast<std::size_t>(std::max(width, 0)));
  const auto begin = numbers.end() - static_cast<std::ptrdiff_t>(shown);
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (auto at = begin; at != numbers.end(); ++at) {
    if (!std::isfinite(*at)) continue;
    low = std::min(low, *at);
    high = std::max(high, *at);
  }
  std::string text(static_cast<std::size_t>(std::max(width, 0)) - shown, ' ');
  for (auto at = begin; at != numbers.end(); ++at) {
    // Halves, because the difference of two numbers may be more than a double holds.
    const double share = high > low ? (*at / 2 - low / 2) / (high / 2 - low / 2) : 0;
    text += std::isfinite(*at)
                ? kBlocks[static_cast<std::size_t>(whole_number(share * kSteps, 0, kSteps))]
                : " ";
  }
  return text;
}

}  // namespace galilean::monitor::top
