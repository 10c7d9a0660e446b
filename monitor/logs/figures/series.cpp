// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/logs/figures/series.h"

#include <algorithm>
#include <cmath>

namespace galilean::logs {

void ValueRange::take(const ValueRange& other) noexcept {
  least = std::min(least, other.least);
  most = std::max(most, other.most);
}

void Series::add(double at_s, double value) {
  if (count_++ == 0) first_s_ = at_s;
  last_s_ = std::max(last_s_, at_s);
  const double since_s = std::max(0.0, at_s - first_s_);
  while (since_s / span_s_ >= static_cast<double>(kMostSpans)) halve();
  const auto span = static_cast<std::size_t>(since_s / span_s_);
  if (span >= spans_.size()) spans_.resize(span + 1);
  const ValueRange one{value, value};
  spans_[span].take(one);
  range_.take(one);
}

void Series::halve() {
  for (std::size_t i = 0; i < spans_.size(); i += 2) {
    ValueRange both = spans_[i];
    if (i + 1 < spans_.size()) both.take(spans_[i + 1]);
    spans_[i / 2] = both;
  }
  spans_.resize((spans_.size() + 1) / 2);
  span_s_ *= 2;
}

std::vector<ValueRange> Series::columns(double from_s, double to_s, std::size_t count) const {
  std::vector<ValueRange> columns(count);
  if (count == 0) return columns;
  const double column_s = std::max(to_s - from_s, 1e-9) / static_cast<double>(count);
  for (std::size_t i = 0; i < spans_.size(); ++i) {
    if (spans_[i].empty()) continue;
    const double at_s = first_s_ + static_cast<double>(i) * span_s_;
    const double column =
        std::clamp((at_s - from_s) / column_s, 0.0, static_cast<double>(count - 1));
    columns[static_cast<std::size_t>(column)].take(spans_[i]);
  }
  return columns;
}

}  // namespace galilean::logs
