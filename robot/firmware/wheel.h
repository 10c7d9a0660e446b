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
///
/// `brake` stops the wheel as fast as the motor can: while it still turns,
///   PWM = dead zone against the motion - braking gain · recent speed,
/// and from then on, or after kLongestBraking_s, PWM = 0, which shorts the motor. The braking gain
/// is the larger of four times the feedforward (the motor then pulls as if towards four times its
/// speed backwards) and the proportional gain.
class Wheel {
 public:
  void set(const WheelGains& gains);
  void aim(float speed_counts_s, float acceleration_counts_s2, float limit_counts);
  /// Brakes a motion that is under way, and forgets it. Does nothing while the wheel brakes or is
  /// at rest.
  void brake();
  /// Resets profile and loop. The PWM is 0 from this moment on.
  void cut();
  /// Takes the encoder's present counts, before each `step`. Requires: `now_ms` is later than
  /// before.
  void measure(std::int32_t encoder_counts, std::uint32_t now_ms) {
    speedometer_.sample(encoder_counts, now_ms);
  }
  /// Runs one period of the loop, `dt_s` seconds long. Returns the PWM to apply.
  std::int16_t step(const DeadZone& dead_zone, float dt_s);

  /// Returns whether a motion is under way, is being braked, or only just ended.
  bool active() const { return motion_ != Motion::kNone; }
  /// Returns whether a motion is under way, or only just ended by itself.
  bool driving() const { return motion_ == Motion::kDriving; }
  float wanted_counts_s() const { return profile_.speed(); }
  float measured_counts_s() const { return speedometer_.speed_counts_s(); }
  void start_at(std::int32_t encoder_counts, std::uint32_t now_ms) {
    speedometer_.reset(encoder_counts, now_ms);
  }

 private:
  enum class Motion : std::uint8_t { kNone, kDriving, kBraking };

  /// However wrong an encoder is, a wheel is not powered for longer than this to stop it.
  static constexpr float kLongestBraking_s = 0.2f;

  std::int16_t braking_pwm(const DeadZone& dead_zone, float dt_s);
  bool settled(float dt_s);

  Trapezoid profile_;
  Speedometer speedometer_;
  Pid pid_;
  float feedforward_ = 0;
  float braking_gain_ = 0;  ///< PWM per count/s
  float rested_s_ = 0;
  float braked_s_ = 0;
  float braking_from_counts_s_ = 0;
  Motion motion_ = Motion::kNone;
};

}  // namespace galilean::robot::firmware
