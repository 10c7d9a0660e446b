// SPDX-License-Identifier: BSD-3-Clause
#include "robot/firmware/drive_train.h"

#include <algorithm>
#include <cmath>

namespace galilean::robot::firmware {
namespace {

constexpr std::uint32_t kLongestTimeout_ms = 120000;
constexpr float kFastest_ticks_s = 2000;
constexpr float kFastestChange_ticks_s2 = 100000;
constexpr float kHighestGain = 1e6f;

/// Returns false for NaN, too.
bool within(float value, float lowest, float highest) {
  return value >= lowest && value <= highest;
}

bool acceptable(const DeadZones& zones) {
  return within(zones.left_forward, 0, kFullPwm) && within(zones.right_forward, 0, kFullPwm) &&
         within(zones.left_reverse, -kFullPwm, 0) && within(zones.right_reverse, -kFullPwm, 0);
}

bool acceptable(const Parameters& p) {
  const bool gains =
      within(p.proportional_gain, 0, kHighestGain) && within(p.integral_gain, 0, kHighestGain) &&
      within(p.derivative_gain, 0, kHighestGain) && within(p.feedforward_gain, 0, kHighestGain);
  const bool motion = within(p.forward_velocity_ticks_s, 0, kFastest_ticks_s) &&
                      within(p.turning_velocity_ticks_s, 0, kFastest_ticks_s) &&
                      within(p.acceleration_ticks_s2, 1, kFastestChange_ticks_s2);
  return gains && motion && acceptable(p.straight_dead_zones) && acceptable(p.turn_dead_zones) &&
         p.timeout_ms > 0 && p.timeout_ms <= kLongestTimeout_ms;
}

WheelGains gains_per_count(const Parameters& p) {
  constexpr float tick_per_count = 1.0f / kCountsPerTick;
  return {{p.proportional_gain * tick_per_count, p.integral_gain * tick_per_count,
           p.derivative_gain * tick_per_count},
          p.feedforward_gain * tick_per_count};
}

float between(std::int16_t straight, std::int16_t turning, float share) {
  return static_cast<float>(straight) + share * static_cast<float>(turning - straight);
}

/// Returns 0 when both wheels run equally fast in the same direction, and 1 when they turn the
/// robot on the spot.
float share_of_turning(float left, float right) {
  const float sum = std::fabs(left) + std::fabs(right);
  return sum > 0 ? std::min(1.0f, std::fabs(left - right) / sum) : 0;
}

}  // namespace

bool DriveTrain::set(const Parameters& parameters) {
  if (!acceptable(parameters)) return false;
  parameters_ = parameters;
  configured_ = true;
  left_.set(gains_per_count(parameters));
  right_.set(gains_per_count(parameters));
  return true;
}

void DriveTrain::start_at(const Inputs& inputs, std::uint32_t now_ms) {
  left_.start_at(inputs.left_encoder_counts, now_ms);
  right_.start_at(inputs.right_encoder_counts, now_ms);
}

void DriveTrain::drive(const Drive& command, std::uint32_t now_ms) {
  float left = command.left_speed_counts_s;
  float right = command.right_speed_counts_s;
  const float fastest = std::max(std::fabs(left), std::fabs(right));
  const float allowed = allowed_speed(left, right);
  if (fastest > allowed) {
    left *= allowed / fastest;
    right *= allowed / fastest;
  }
  const float acceleration = parameters_.acceleration_ticks_s2 * kCountsPerTick;
  left_.aim(left, acceleration, static_cast<float>(command.left_limit_counts));
  right_.aim(right, acceleration, static_cast<float>(command.right_limit_counts));
  last_drive_ms_ = last_heard_ms_ = now_ms;
  stopped_by_timeout_ = false;
}

void DriveTrain::brake() {
  left_.brake();
  right_.brake();
}

void DriveTrain::step(const Inputs& inputs, std::uint32_t now_ms, float dt_s, Outputs& outputs) {
  watch(now_ms);
  left_.measure(inputs.left_encoder_counts, now_ms);
  right_.measure(inputs.right_encoder_counts, now_ms);
  const float turning = share_of_turning(left_.wanted_counts_s(), right_.wanted_counts_s());
  const DeadZones& straight = parameters_.straight_dead_zones;
  const DeadZones& turn = parameters_.turn_dead_zones;
  const DeadZone left{between(straight.left_forward, turn.left_forward, turning),
                      between(straight.left_reverse, turn.left_reverse, turning)};
  const DeadZone right{between(straight.right_forward, turn.right_forward, turning),
                       between(straight.right_reverse, turn.right_reverse, turning)};
  outputs.left_pwm = left_.step(left, dt_s);
  outputs.right_pwm = right_.step(right, dt_s);
}

void DriveTrain::watch(std::uint32_t now_ms) {
  const bool driving = left_.driving() || right_.driving();
  const bool heard = now_ms - last_heard_ms_ < kStopTimer_ms;
  const bool lasts = now_ms - last_drive_ms_ < parameters_.timeout_ms;
  if (!driving || (heard && lasts)) return;
  brake();
  stopped_by_timeout_ = true;
}

float DriveTrain::allowed_speed(float left, float right) const {
  const float turning = share_of_turning(left, right);
  const float straight_speed = parameters_.forward_velocity_ticks_s;
  const float speed =
      straight_speed + turning * (parameters_.turning_velocity_ticks_s - straight_speed);
  return speed * kCountsPerTick;
}

}  // namespace galilean::robot::firmware
