// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/device/device.h"

namespace galilean {

/// One movement of the robot. The wheels stop by themselves when a limit is reached, or soon after
/// neither a command nor its renewal comes.
struct DriveCommand {
  double speed_mps = 0;         ///< forward positive
  double turn_rate_radps = 0;   ///< counter-clockwise positive
  double distance_limit_m = 0;  ///< how far the robot's centre moves at most; 0: no limit
  double angle_limit_rad = 0;   ///< how far the robot turns at most; 0: no limit
};

/// The paper's motor_drive: steering and translation.
class MotorDrive : public Device {
 public:
  virtual void drive(const DriveCommand& command) noexcept = 0;
  /// Renews the movement that was ordered last. Its limits count on. Motors that stop by themselves
  /// need it, or another command, in every tick.
  virtual void keep_moving() noexcept {}
  virtual void stop() noexcept = 0;
  /// Returns a speed that the program sets in its motor_drive. Schemas drive with the first and
  /// turn with the second.
  [[nodiscard]] virtual double forward_speed_mps() const noexcept = 0;
  [[nodiscard]] virtual double turning_speed_radps() const noexcept = 0;
  /// Returns half the distance between the wheels [m]. A wheel travels this far for each radian
  /// that the robot turns in place.
  [[nodiscard]] virtual double turn_radius_m() const noexcept = 0;
};

}  // namespace galilean
