// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <chrono>
#include <cstdint>

namespace galilean::sim {

/// Says how fast simulated time runs beside real time, and whether it stands still.
class Pace {
 public:
  static constexpr double kSlowest = 0.1;
  static constexpr double kFastest = 20;

  void pause() noexcept {
    paused_ = true;
    left_ = 0;
  }
  void go_on() noexcept {
    paused_ = false;
    left_ = 0;
  }
  /// Lets this many steps happen, and then pauses.
  /// Requires: steps > 0.
  void run_steps(std::uint64_t steps) noexcept {
    paused_ = false;
    left_ = steps;
  }
  /// Requires: kSlowest <= rate <= kFastest.
  void set_rate(double rate) noexcept { rate_ = rate; }

  /// Returns whether the next step may happen, which the caller then takes.
  [[nodiscard]] bool take_step() noexcept {
    if (paused_) return false;
    if (left_ > 0 && --left_ == 0) paused_ = true;
    return true;
  }
  [[nodiscard]] bool paused() const noexcept { return paused_; }
  [[nodiscard]] double rate() const noexcept { return rate_; }
  /// Returns the real time that a step of this much simulated time takes.
  [[nodiscard]] std::chrono::nanoseconds real_time(std::chrono::nanoseconds step) const noexcept {
    return std::chrono::nanoseconds(
        static_cast<std::int64_t>(static_cast<double>(step.count()) / rate_));
  }

 private:
  bool paused_ = false;
  std::uint64_t left_ = 0;  ///< steps until the next pause; 0: no pause is due
  double rate_ = 1;
};

}  // namespace galilean::sim
