// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

#include "robot/firmware/pid.h"
#include "robot/firmware/speedometer.h"
#include "robot/firmware/trapezoid.h"

namespace galilean::robot::firmware {

struct WheelGains {
  PidGains pid;           ///< PWM per count/s of speed error
  float feedforward = 0;  ///< PWM per count/s of wanted speed
};

/// The PWM up to which the motor does not move: forward ≥ 0, reverse ≤ 0.
struct DeadZone {
  float forward_pwm = 0;
  float reverse_pwm = 0;
};

/// Closes the speed loop of one motor around its trapezoidal profile.
///   PWM = dead zone in the direction of motion + feedforward · wanted + PID(wanted, measured)
/// When the profile has come to rest, the loop corrects for a moment longer and then lets go, so
/// that a standing robot neither hums nor creeps.
class Wheel {
 public:
  void set(const WheelGains& gains);
  void aim(float speed_counts_s, float acceleration_counts_s2, float limit_counts);
  /// Resets profile and loop. The PWM is 0 from this moment on.
  void cut();
  /// Takes the encoder's present counts, before each `step`. Requires: `now_ms` is later than
  /// before.
  void measure(std::int32_t encoder_counts, std::uint32_t now_ms) {
    speedometer_.sample(encoder_counts, now_ms);
  }
  /// Runs one period of the loop, `dt_s` seconds long. Returns the PWM to apply.
  std::int16_t step(const DeadZone& dead_zone, float dt_s);

  /// Returns whether a motion is under way, or only just ended.
  bool active() const { return active_; }
  float wanted_counts_s() const { return profile_.speed(); }
  float measured_counts_s() const { return speedometer_.speed_counts_s(); }
  void start_at(std::int32_t encoder_counts, std::uint32_t now_ms) {
    speedometer_.reset(encoder_counts, now_ms);
  }

 private:
  bool settled(float dt_s);

  Trapezoid profile_;
  Speedometer speedometer_;
  Pid pid_;
  float feedforward_ = 0;
  float rested_s_ = 0;
  bool active_ = false;
};

}  // namespace galilean::robot::firmware
