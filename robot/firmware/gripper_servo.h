// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

#include "robot/firmware/messages.h"

namespace galilean::robot::firmware {

/// Moves the gripper's servo between its ends at a constant speed. The servo reports nothing back.
/// The position is therefore the commanded one. The servo follows it, or presses on what stops it.
class GripperServo {
 public:
  /// The time from one end to the other.
  static constexpr std::int32_t kStroke_ms = 400;

  void close() { wanted_ms_ = kStroke_ms; }
  void open() { wanted_ms_ = 0; }
  /// Returns the position for the servo after the next `elapsed_ms`, in permille.
  std::int16_t step(std::int32_t elapsed_ms);

  GripperState state() const;
  std::uint8_t percent() const {
    return static_cast<std::uint8_t>(position_ms_ * kFull_percent / kStroke_ms);
  }

 private:
  static constexpr std::int32_t kFull_permille = 1000;
  static constexpr std::int32_t kFull_percent = 100;

  /// The position in milliseconds of the stroke from open. A whole number of these is exact,
  /// whatever the lengths of the steps are.
  std::int32_t position_ms_ = 0;
  std::int32_t wanted_ms_ = 0;
};

}  // namespace galilean::robot::firmware
