// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

namespace galilean::robot {

/// Computes the travel of both wheels [m] from encoder counts that wrap around. It sums up
/// differences, so that a change of the scale does not change the travel so far.
class Odometer {
 public:
  /// Begins anew with a board that has just started. Its counts are the whole travel.
  void restart(std::int32_t left_counts, std::int32_t right_counts, double counts_per_m) {
    left_ = {left_counts, left_counts / counts_per_m};
    right_ = {right_counts, right_counts / counts_per_m};
  }
  void update(std::int32_t left_counts, std::int32_t right_counts, double counts_per_m) {
    left_.advance(left_counts, counts_per_m);
    right_.advance(right_counts, counts_per_m);
  }
  [[nodiscard]] double left_m() const { return left_.travel_m; }
  [[nodiscard]] double right_m() const { return right_.travel_m; }

 private:
  struct Wheel {
    std::int32_t counts = 0;
    double travel_m = 0;

    void advance(std::int32_t now, double counts_per_m) {
      const auto difference = static_cast<std::uint32_t>(now) - static_cast<std::uint32_t>(counts);
      travel_m += static_cast<std::int32_t>(difference) / counts_per_m;
      counts = now;
    }
  };

  Wheel left_;
  Wheel right_;
};

}  // namespace galilean::robot
