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

float offset(const DeadZone& zone, float wanted, float output) {
  if (wanted > 0) return zone.forward_pwm;
  if (wanted < 0) return zone.reverse_pwm;
  const float share = std::min(1.0f, (output < 0 ? -output : output) / kSoftening_pwm);
  return share * (output < 0 ? zone.reverse_pwm : zone.forward_pwm);
}

}  // namespace

void Wheel::set(const WheelGains& gains) {
  pid_.set(gains.pid, kFullPwm);
  feedforward_ = gains.feedforward;
}

void Wheel::aim(float speed_counts_s, float acceleration_counts_s2, float limit_counts) {
  if (!active_) profile_.start_from(measured_counts_s());
  profile_.aim(speed_counts_s, acceleration_counts_s2, limit_counts);
  if (!profile_.resting()) active_ = true;
}

void Wheel::cut() {
  profile_.cut();
  pid_.reset();
  active_ = false;
}

std::int16_t Wheel::step(const DeadZone& dead_zone, float dt_s) {
  if (!active_) return 0;
  const float wanted = profile_.step(dt_s);
  if (settled(dt_s)) {
    cut();
    return 0;
  }
  const Measured measured{speedometer_.speed_counts_s(), speedometer_.change_counts_s2()};
  const float output = feedforward_ * wanted + pid_.step(wanted, measured, dt_s);
  const float pwm = output + offset(dead_zone, wanted, output);
  return static_cast<std::int16_t>(std::clamp(pwm, -float{kFullPwm}, float{kFullPwm}));
}

bool Wheel::settled(float dt_s) {
  rested_s_ = profile_.resting() ? rested_s_ + dt_s : 0;
  return rested_s_ > kSettling_s;
}

}  // namespace galilean::robot::firmware
