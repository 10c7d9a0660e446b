// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <cstdint>
#include <deque>
#include <span>
#include <vector>

#include "robot/firmware/hardware.h"
#include "robot/firmware/messages.h"

namespace galilean::robot::firmware {

inline constexpr float kStep_s = 0.002f;
inline constexpr std::uint32_t kStep_ms = 2;

/// Returns the parameters that a robot would give the board.
inline Parameters bench_parameters(std::uint16_t timeout_ms) {
  Parameters p;
  p.proportional_gain = 8;
  p.integral_gain = 80;
  p.feedforward_gain = 3.5;
  p.straight_dead_zones = {200, 200, -200, -200};
  p.turn_dead_zones = {330, 330, -330, -330};
  p.forward_velocity_ticks_s = p.turning_velocity_ticks_s = 100;
  p.acceleration_ticks_s2 = 300;
  p.timeout_ms = timeout_ms;
  return p;
}

/// A direct-current motor with its drive train. Below its dead zone it stands. Above it, its speed
/// follows (|PWM| - dead zone) / slope with a first-order lag.
class BenchMotor {
 public:
  double dead_zone_pwm = 200;
  double pwm_per_count_s = 4.0 / kCountsPerTick;
  double lag_s = 0.08;
  bool blocked = false;

  void step(int pwm, double dt_s) {
    const double above = std::max(0.0, std::abs(pwm) - dead_zone_pwm);
    const double wanted = blocked ? 0 : std::copysign(above / pwm_per_count_s, pwm);
    speed_counts_s_ += (wanted - speed_counts_s_) * std::min(1.0, dt_s / lag_s);
    counts_ += speed_counts_s_ * dt_s;
  }
  double speed_counts_s() const { return speed_counts_s_; }
  std::int32_t counts() const { return static_cast<std::int32_t>(std::floor(counts_)); }

 private:
  double speed_counts_s_ = 0;
  double counts_ = 0;
};

/// A board on the bench with two motors, switches that the test sets, and two queues as its serial
/// line.
class BenchBoard final : public Hardware {
 public:
  BenchMotor left;
  BenchMotor right;
  std::uint8_t bumpers = 0;
  bool beam_broken = false;
  Outputs outputs;
  std::deque<std::uint8_t> to_board;
  std::vector<std::uint8_t> from_board;

  void step(double dt_s) {
    left.step(outputs.left_pwm, dt_s);
    right.step(outputs.right_pwm, dt_s);
  }
  Inputs read() override { return {left.counts(), right.counts(), bumpers, beam_broken}; }
  void write(const Outputs& pins) override { outputs = pins; }
  std::size_t receive(std::span<std::uint8_t> bytes) override {
    std::size_t count = 0;
    for (; count < bytes.size() && !to_board.empty(); ++count) {
      bytes[count] = to_board.front();
      to_board.pop_front();
    }
    return count;
  }
  std::size_t send(std::span<const std::uint8_t> bytes) override {
    from_board.insert(from_board.end(), bytes.begin(), bytes.end());
    return bytes.size();
  }
};

}  // namespace galilean::robot::firmware
