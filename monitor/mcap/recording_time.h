// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>
#include <vector>

#include "monitor/mcap/damage.h"

namespace galilean::mcap {

/// No message for longer than this is no part of a recording's duration: the clock was set, a
/// message carries a wrong time, or the recording paused.
inline constexpr std::uint64_t kLongestSilence_ns = std::uint64_t{600} * 1'000'000'000;

/// Counts the time of a recording from message to message, without the silences.
class RecordingTime {
 public:
  /// Moves on to a message. One that is older than the newest before it changes nothing.
  void move_to(std::uint64_t log_ns) {
    const std::uint64_t before_ns = newest_ns_.value_or(log_ns);
    if (!newest_ns_) first_ns_ = log_ns;
    newest_ns_ = std::max(before_ns, log_ns);
    if (log_ns <= before_ns) return;
    if (log_ns - before_ns > kLongestSilence_ns)
      silences_.push_back({before_ns, log_ns});
    else
      position_ns_ += log_ns - before_ns;
  }
  /// Returns the time since the first message, without the silences.
  [[nodiscard]] std::uint64_t position_ns() const noexcept { return position_ns_; }
  /// Returns the log time of a position [both ns]. The position of a silence is the silence's end.
  /// Requires: it was moved to a message, and `position_ns` is at most position_ns().
  [[nodiscard]] std::uint64_t log_ns_at(std::uint64_t position_ns) const noexcept {
    std::uint64_t log_ns = first_ns_ + position_ns;
    for (const auto& silence : silences_) {
      if (log_ns < silence.start_ns) break;
      log_ns += silence.end_ns - silence.start_ns;
    }
    return log_ns;
  }
  [[nodiscard]] bool has_begun() const noexcept { return newest_ns_.has_value(); }
  [[nodiscard]] const std::vector<TimeRange>& silences() const noexcept { return silences_; }

 private:
  std::optional<std::uint64_t> newest_ns_;
  std::uint64_t first_ns_ = 0;
  std::uint64_t position_ns_ = 0;
  std::vector<TimeRange> silences_;
};

}  // namespace galilean::mcap
