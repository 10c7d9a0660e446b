// SPDX-License-Identifier: BSD-3-Clause
#include "robot/firmware/trapezoid.h"

#include <algorithm>
#include <cmath>

namespace galilean::robot::firmware {

void Trapezoid::aim(float speed, float acceleration, float travel_limit) {
  target_ = speed;
  acceleration_ = acceleration;
  limited_ = travel_limit > 0 && speed != 0;
  direction_ = speed < 0 ? -1.0f : 1.0f;
  travel_left_ = travel_limit;
}

void Trapezoid::cut() {
  speed_ = target_ = 0;
  limited_ = false;
}

float Trapezoid::step(float dt_s) {
  const float change = acceleration_ * dt_s;
  float next = std::clamp(target_, speed_ - change, speed_ + change);
  if (limited_) {
    const float along = std::min(next * direction_, fastest_that_stops_in_time(dt_s));
    next = direction_ * std::max(along, speed_ * direction_ - change);
  }
  const float travel = (speed_ + next) / 2 * dt_s;
  speed_ = next;
  if (limited_) count_down(travel * direction_);
  return speed_;
}

float Trapezoid::fastest_that_stops_in_time(float dt_s) const {
  const auto after_this_step = static_cast<float>(travel_left_ - speed_ * direction_ * dt_s / 2);
  if (after_this_step <= 0) return 0;
  const float ramp = acceleration_ * dt_s / 2;
  return std::sqrt(ramp * ramp + 2 * acceleration_ * after_this_step) - ramp;
}

void Trapezoid::count_down(float travel) {
  travel_left_ -= travel;
  constexpr float arrived = 1e-3f;
  if (travel_left_ > arrived || speed_ * direction_ > acceleration_ * arrived) return;
  limited_ = false;
  target_ = 0;
}

}  // namespace galilean::robot::firmware
