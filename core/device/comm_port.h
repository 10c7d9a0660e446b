// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

#include "core/clock.h"
#include "core/device/device.h"

namespace galilean {

/// The last status that the microcontroller reported.
struct ControllerStatus {
  static constexpr int kBumpers = 8;

  Time received{};              ///< when it arrived here
  std::uint8_t bumpers = 0;     ///< bit i: switch i is pressed
  bool beam_broken = false;     ///< something stands between the gripper's hands
  bool gripper_closed = false;  ///< the servo has reached its closed stop
  double left_travel_m = 0;     ///< of the left wheel since the board started, forward positive
  double right_travel_m = 0;
  double left_speed_mps = 0;
  double right_speed_mps = 0;
  std::uint32_t epoch = 0;  ///< counts the board's restarts: travel began anew
};

enum class GripperCommand : std::uint8_t { kOpen, kClose };

/// The paper's comm_port: the serial line to the microcontroller.
class CommPort : public Device {
 public:
  /// Returns the status that the last `sense` took. While the line is down (see `healthy`) it stays
  /// the last known one.
  [[nodiscard]] virtual const ControllerStatus& status() const noexcept = 0;
  virtual void command_gripper(GripperCommand command) noexcept = 0;
};

}  // namespace galilean
