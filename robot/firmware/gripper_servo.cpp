// SPDX-License-Identifier: BSD-3-Clause
#include "robot/firmware/gripper_servo.h"

#include <algorithm>

namespace galilean::robot::firmware {

std::int16_t GripperServo::step(std::int32_t elapsed_ms) {
  position_ms_ = std::clamp(wanted_ms_, position_ms_ - elapsed_ms, position_ms_ + elapsed_ms);
  return static_cast<std::int16_t>(position_ms_ * kFull_permille / kStroke_ms);
}

GripperState GripperServo::state() const {
  if (wanted_ms_ == kStroke_ms)
    return position_ms_ == kStroke_ms ? GripperState::kClosed : GripperState::kClosing;
  return position_ms_ == 0 ? GripperState::kOpen : GripperState::kOpening;
}

}  // namespace galilean::robot::firmware
