#pragma once

#include <cmath>
#include <cstdint>
#include <deque>
#include <span>
#include <vector>

#include "robot/firmware/hardware.h"

namespace galilean::robot::firmware {

/// A direct-current motor with its drive train: below its dead zone it stands, above it its speed
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

/// A board on the bench: two motors, switches under the test's fingers, a serial line as two
/// queues.
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
