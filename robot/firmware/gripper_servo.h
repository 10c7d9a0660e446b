// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

#include "robot/firmware/messages.h"

namespace galilean::robot::firmware {

/// Leads the gripper's servo at a steady pace between its ends. The servo tells nothing back: the
/// position is the one it was told, which it follows at this pace, or holds on to what stops it.
class GripperServo {
 public:
  /// From one end to the other.
  static constexpr std::int32_t kStroke_ms = 400;

  void close() { wanted_ms_ = kStroke_ms; }
  void open() { wanted_ms_ = 0; }
  /// In permille, where the servo is to stand after the next `elapsed_ms`.
  std::int16_t step(std::int32_t elapsed_ms);

  GripperState state() const;
  std::uint8_t percent() const {
    return static_cast<std::uint8_t>(position_ms_ * kFull_percent / kStroke_ms);
  }

 private:
  static constexpr std::int32_t kFull_permille = 1000;
  static constexpr std::int32_t kFull_percent = 100;

  /// Milliseconds of the stroke from open, so that no step's length loses a part of it.
  std::int32_t position_ms_ = 0;
  std::int32_t wanted_ms_ = 0;
};

}  // namespace galilean::robot::firmware
