// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/logs/figures/state_bars.h"

#include <algorithm>

namespace galilean::logs {

void StateBars::add(double at_s, const std::string& text) {
  last_s_ = std::max(last_s_, at_s);
  const auto name = index_of(text);
  if (!runs_.empty() && runs_.back().name == name) return;
  if (runs_.size() == kMostRuns) halve();
  runs_.push_back({at_s, name});
}

std::size_t StateBars::index_of(const std::string& text) {
  const auto known = std::ranges::find(names_, text);
  if (known != names_.end()) return static_cast<std::size_t>(known - names_.begin());
  if (names_.size() < kMostNames) {
    names_.push_back(text);
    return names_.size() - 1;
  }
  if (names_.size() == kMostNames) names_.emplace_back(kOthers);
  return kMostNames;
}

/// Half of what changes so often is still more than a picture has columns.
void StateBars::halve() {
  std::size_t kept = 0;
  for (std::size_t i = 0; i < runs_.size(); i += 2) runs_[kept++] = runs_[i];
  runs_.resize(kept);
}

std::vector<std::optional<std::size_t>> StateBars::columns(double from_s, double to_s,
                                                           std::size_t count) const {
  std::vector<std::optional<std::size_t>> columns(count);
  const double column_s = std::max(to_s - from_s, 1e-9) / static_cast<double>(count);
  auto run = runs_.begin();
  for (std::size_t i = 0; i < count; ++i) {
    const double begin_s = from_s + static_cast<double>(i) * column_s;
    while (run != runs_.end() && run->at_s < begin_s + column_s) ++run;
    if (run != runs_.begin() && begin_s <= last_s_) columns[i] = (run - 1)->name;
  }
  return columns;
}

}  // namespace galilean::logs
