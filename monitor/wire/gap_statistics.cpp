// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/wire/gap_statistics.h"

#include <algorithm>
#include <cmath>

namespace galilean::monitor {

void GapStatistics::add(Time received, std::size_t bytes) noexcept {
  if (messages_++ == 0) {
    first_ = last_ = received;
    return;
  }
  const double gap_s = to_seconds(received - last_);
  const auto gaps = static_cast<double>(messages_ - 1);
  last_ = received;
  bytes_ += bytes;
  least_s_ = messages_ == 2 ? gap_s : std::min(least_s_, gap_s);
  most_s_ = std::max(most_s_, gap_s);
  const double before = gap_s - mean_s_;
  mean_s_ += before / gaps;
  squares_s2_ += before * (gap_s - mean_s_);
}

std::optional<GapStatistics::Figures> GapStatistics::figures() const {
  const double span_s = to_seconds(last_ - first_);
  if (messages_ < 2 || span_s <= 0) return std::nullopt;
  const auto gaps = static_cast<double>(messages_ - 1);
  return Figures{gaps / span_s,
                 least_s_,
                 most_s_,
                 mean_s_,
                 std::sqrt(squares_s2_ / gaps),
                 static_cast<double>(bytes_) / span_s};
}

}  // namespace galilean::monitor
