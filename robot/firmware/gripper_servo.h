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

  void close() { wanted_permille_ = kClosed; }
  void open() { wanted_permille_ = kOpen; }
  /// Where the servo is to stand after the next `elapsed_ms`.
  std::int16_t step(std::int32_t elapsed_ms);

  GripperState state() const;
  std::uint8_t percent() const { return static_cast<std::uint8_t>(position_permille_ / 10); }

 private:
  static constexpr std::int32_t kOpen = 0;
  static constexpr std::int32_t kClosed = 1000;

  std::int32_t position_permille_ = kOpen;
  std::int32_t wanted_permille_ = kOpen;
};

}  // namespace galilean::robot::firmware
