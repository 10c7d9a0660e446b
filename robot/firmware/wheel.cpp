// SPDX-License-Identifier: BSD-3-Clause
#include "robot/firmware/wheel.h"

#include <algorithm>

#include "robot/firmware/hardware.h"

namespace galilean::robot::firmware {
namespace {

/// How long the control loop goes on after the profile came to rest.
constexpr float kSettling_s = 0.15f;
/// At rest the dead zone is added in proportion to the output, up to this output. The full dead
/// zone would make the motor chatter.
constexpr float kSoftening_pwm = 40;
/// How many times the power that holds a speed is used to brake from it. A higher factor makes the
/// loop swing where it runs every 10 ms.
constexpr float kBrakingFactor = 4;

float offset(const DeadZone& zone, float wanted, float output) {
  if (wanted > 0) return zone.forward_pwm;
  if (wanted < 0) return zone.reverse_pwm;
  const float share = std::min(1.0f, (output < 0 ? -output : output) / kSoftening_pwm);
  return share * (output < 0 ? zone.reverse_pwm : zone.forward_pwm);
}

std::int16_t whole_pwm(float pwm) {
  return static_cast<std::int16_t>(std::clamp(pwm, -float{kFullPwm}, float{kFullPwm}));
}

}  // namespace

void Wheel::set(const WheelGains& gains) {
  pid_.set(gains.pid, kFullPwm);
  feedforward_ = gains.feedforward;
  braking_gain_ = std::max(kBrakingFactor * gains.feedforward, gains.pid.proportional);
}

void Wheel::aim(float speed_counts_s, float acceleration_counts_s2, float limit_counts) {
  if (!driving()) profile_.start_from(speedometer_.recent_speed_counts_s());
  profile_.aim(speed_counts_s, acceleration_counts_s2, limit_counts);
  if (!profile_.resting()) motion_ = Motion::kDriving;
}

void Wheel::brake() {
  if (!driving()) return;
  cut();
  braked_s_ = 0;
  braking_from_counts_s_ = speedometer_.recent_speed_counts_s();
  motion_ = Motion::kBraking;
}

void Wheel::cut() {
  profile_.cut();
  pid_.reset();
  motion_ = Motion::kNone;
}

std::int16_t Wheel::step(const DeadZone& dead_zone, float dt_s) {
  if (motion_ == Motion::kNone) return 0;
  if (motion_ == Motion::kBraking) return braking_pwm(dead_zone, dt_s);
  const float wanted = profile_.step(dt_s);
  if (settled(dt_s)) {
    cut();
    return 0;
  }
  const Measured measured{speedometer_.speed_counts_s(), speedometer_.change_counts_s2()};
  const float output = feedforward_ * wanted + pid_.step(wanted, measured, dt_s);
  return whole_pwm(output + offset(dead_zone, wanted, output));
}

std::int16_t Wheel::braking_pwm(const DeadZone& dead_zone, float dt_s) {
  const float speed = speedometer_.recent_speed_counts_s();
  braked_s_ += dt_s;
  const bool stands = speed * braking_from_counts_s_ <= 0;
  if (stands || braked_s_ > kLongestBraking_s) {
    cut();
    return 0;
  }
  const float against = speed > 0 ? dead_zone.reverse_pwm : dead_zone.forward_pwm;
  return whole_pwm(against - braking_gain_ * speed);
}

bool Wheel::settled(float dt_s) {
  rested_s_ = profile_.resting() ? rested_s_ + dt_s : 0;
  return rested_s_ > kSettling_s;
}

}  // namespace galilean::robot::firmware
