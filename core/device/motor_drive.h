// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/device/device.h"

namespace galilean {

/// One movement. The wheels stop by themselves after the limits, or when commands cease.
struct DriveCommand {
  double speed_mps = 0;         ///< forward positive
  double turn_rate_radps = 0;   ///< counter-clockwise positive
  double distance_limit_m = 0;  ///< of the robot's centre; 0: none
  double angle_limit_rad = 0;   ///< 0: none
};

/// The paper's motor_drive: steering and translation.
class MotorDrive : public Device {
 public:
  virtual void drive(const DriveCommand& command) noexcept = 0;
  virtual void stop() noexcept = 0;
  /// Speeds that the program asks for: what a schema drives and turns with.
  [[nodiscard]] virtual double forward_speed_mps() const noexcept = 0;
  [[nodiscard]] virtual double turning_speed_radps() const noexcept = 0;
  /// Half the track: metres of wheel travel a radian of turning in place.
  [[nodiscard]] virtual double turn_radius_m() const noexcept = 0;
};

}  // namespace galilean
