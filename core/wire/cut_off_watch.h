// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <chrono>
#include <cstdint>

#include "core/clock.h"

namespace galilean::wire {

/// Tells which of a robot's events fill a gap: the robot could not be heard when they happened, and
/// DDS handed them over when it was heard again. Robots send their state ten times a second, so
/// that a time without one is such a gap.
///
/// A gap is noticed by the clock of whoever listens. Its borders are the stamps of the states
/// beside it, so that only stamps of one clock, the robot's, are compared. How late an event comes
/// is reckoned from the newest state: what a robot does first after it was started again comes in
/// time, and fills no gap. Neither does what happened before the robot was heard first.
class CutOffWatch {
 public:
  /// A gap is longer than this, and an event that fills it comes later than this.
  static constexpr Duration kLeast = std::chrono::seconds(2);

  /// Notes that a state came at `now`, by the listener's clock. `sent_ns` is when it was sent, by
  /// the robot's clock. Requires: `now` does not go back.
  void note_state(Time now, std::int64_t sent_ns) noexcept {
    if (is_cut_off(now)) {
      from_ns_ = last_sent_ns_;
      until_ns_ = sent_ns;
    }
    is_heard_ = true;
    last_ = now;
    last_sent_ns_ = sent_ns;
  }

  /// Returns whether an event that came at `now`, and was sent at `sent_ns`, fills the newest gap.
  [[nodiscard]] bool fills_gap(Time now, std::int64_t sent_ns) const noexcept {
    const bool is_within =
        is_cut_off(now) ? sent_ns > last_sent_ns_ : sent_ns > from_ns_ && sent_ns < until_ns_;
    return is_within && lateness_s(now, sent_ns) > to_seconds(kLeast);
  }

 private:
  /// Returns whether a state is overdue, so that a gap has not ended yet.
  [[nodiscard]] bool is_cut_off(Time now) const noexcept {
    return is_heard_ && now - last_ > kLeast;
  }
  /// Others choose the stamps, so that the difference of two may be beyond what a stamp holds.
  [[nodiscard]] double lateness_s(Time now, std::int64_t sent_ns) const noexcept {
    const double since_state_ns = static_cast<double>(sent_ns) - static_cast<double>(last_sent_ns_);
    return to_seconds(now - last_) - since_state_ns * 1e-9;
  }

  bool is_heard_ = false;
  Time last_{};
  std::int64_t last_sent_ns_ = 0;
  std::int64_t from_ns_ = 0, until_ns_ = 0;  ///< the newest gap; equal: there was none
};

}  // namespace galilean::wire
