// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>

#include "core/geometry.h"

namespace galilean::sim {

/// Measures how long a robot that tries to move has stood still. It stands still while its centre
/// stays within 5 cm, and its heading within 10 degrees, of where this began. Time in states whose
/// motor schemas do not drive does not count, and resets the measurement.
class StuckWatch {
 public:
  static constexpr double kReach_m = 0.05;
  static constexpr double kReach_rad = 10 * kPi / 180;

  void see(const Pose2& pose, bool trying, double dt_s) noexcept {
    const bool moved = (pose.position_m - anchor_.position_m).norm() > kReach_m ||
                       std::abs(wrap_angle(pose.heading_rad - anchor_.heading_rad)) > kReach_rad;
    if (moved || !trying) {
      anchor_ = pose;
      stuck_s_ = 0;
      return;
    }
    stuck_s_ += dt_s;
    longest_s_ = std::max(longest_s_, stuck_s_);
  }
  [[nodiscard]] double stuck_s() const noexcept { return stuck_s_; }
  [[nodiscard]] double longest_s() const noexcept { return longest_s_; }

 private:
  Pose2 anchor_;
  double stuck_s_ = 0;
  double longest_s_ = 0;
};

}  // namespace galilean::sim
