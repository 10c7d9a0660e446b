// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "core/catalog/declaration.h"
#include "robot/firmware/messages.h"

namespace galilean::robot {

/// A program's settings for the motors (BHDL: motor_drive). Speeds are those of a wheel.
struct MotorDriveSettings {
  double forward_velocity_ticks_s = 100;
  double turning_velocity_ticks_s = 100;
  double acceleration_ticks_s2 = 300;
  std::vector<double> straight_dead_zones_pwm{200, 200, -200, -200};
  std::vector<double> turn_dead_zones_pwm{330, 330, -330, -330};
  double proportional_gain = 8;
  double integral_gain = 80;
  double derivative_gain = 0;
  double feedforward_gain = 3.5;
  double turn_radius_m = 0.185;
  double ticks_per_m = 325;
  double timeout_s = 0.5;

  static void describe(Declaration<MotorDriveSettings>& is);
  /// What schemas ask the motor_drive for.
  struct Motion {
    double forward_speed_mps = 0;
    double turning_speed_radps = 0;
    double turn_radius_m = 0;
  };
  [[nodiscard]] Motion motion() const noexcept {
    return {forward_velocity_ticks_s / ticks_per_m,
            turning_velocity_ticks_s / ticks_per_m / turn_radius_m, turn_radius_m};
  }
  /// Returns the settings in the form that the board takes.
  [[nodiscard]] firmware::Parameters parameters() const noexcept;
};

}  // namespace galilean::robot
