#include "robot/firmware/gripper_servo.h"

#include <algorithm>

namespace galilean::robot::firmware {

std::int16_t GripperServo::step(std::int32_t elapsed_ms) {
  const std::int32_t change = elapsed_ms * kClosed / kStroke_ms;
  position_permille_ =
      std::clamp(wanted_permille_, position_permille_ - change, position_permille_ + change);
  return static_cast<std::int16_t>(position_permille_);
}

GripperState GripperServo::state() const {
  if (wanted_permille_ == kClosed)
    return position_permille_ == kClosed ? GripperState::kClosed : GripperState::kClosing;
  return position_permille_ == kOpen ? GripperState::kOpen : GripperState::kOpening;
}

}  // namespace galilean::robot::firmware
