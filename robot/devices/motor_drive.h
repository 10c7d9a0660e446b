// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>

#include "core/device/motor_drive.h"
#include "robot/devices/microcontroller_link.h"
#include "robot/devices/motor_drive_settings.h"

namespace galilean::robot {

/// The motor_drive of a robot: turns the movement of its centre into that of its wheels.
/// Law, with r half the track and ω counter-clockwise:  left = v − ω·r,  right = v + ω·r,  and a
/// wheel's limit is what it travels until the first limit is reached, after T = min(D/|v|, A/|ω|).
class WheelDrive final : public MotorDrive {
 public:
  WheelDrive(MicrocontrollerLink& link, const MotorDriveSettings& settings);

  /// Applies another program's settings. Belongs to the control loop. It neither allocates nor
  /// waits.
  void configure(const MotorDriveSettings& settings) noexcept;

  void sense(Time) noexcept override {}
  [[nodiscard]] bool healthy() const noexcept override { return link_.healthy(); }
  [[nodiscard]] std::string problem() const override;
  void drive(const DriveCommand& command) noexcept override;
  void keep_moving() noexcept override { link_.keep_moving(); }
  void stop() noexcept override { link_.stop(); }
  [[nodiscard]] double forward_speed_mps() const noexcept override {
    return motion_.forward_speed_mps;
  }
  [[nodiscard]] double turning_speed_radps() const noexcept override {
    return motion_.turning_speed_radps;
  }
  [[nodiscard]] double turn_radius_m() const noexcept override { return motion_.turn_radius_m; }

 private:
  MicrocontrollerLink& link_;
  double counts_per_m_ = 0;
  MotorDriveSettings::Motion motion_;
};

}  // namespace galilean::robot
