// SPDX-License-Identifier: BSD-3-Clause
#include "robot/firmware/pid.h"

#include <algorithm>

namespace galilean::robot::firmware {

void Pid::set(const PidGains& gains, float output_limit) {
  gains_ = gains;
  limit_ = output_limit;
}

void Pid::reset() {
  integral_ = 0;
}

float Pid::step(float wanted, const Measured& measured, float dt_s) {
  const float error = wanted - measured.value;
  const float summed = integral_ + gains_.integral * error * dt_s;
  const float output = gains_.proportional * error + summed - gains_.derivative * measured.change_s;
  const bool further_into_limit = (output > limit_ && error > 0) || (output < -limit_ && error < 0);
  if (!further_into_limit) integral_ = summed;
  return std::clamp(output, -limit_, limit_);
}

}  // namespace galilean::robot::firmware
