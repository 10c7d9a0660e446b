// SPDX-License-Identifier: BSD-3-Clause
#include "robot/motor/move_robot.h"

#include <algorithm>
#include <cmath>

#include "core/device/bumpers.h"
#include "core/device/device_names.h"
#include "core/device/devices.h"
#include "robot/variables/relative.h"

namespace galilean::robot {
namespace {

constexpr double kStandstill = 1e-6;  ///< shorter forces count as having no direction

bool towards_pressed(const Vec2& motion, std::uint32_t pressed) noexcept {
  for (int i = 0; i < ControllerStatus::kBumpers; ++i)
    if ((pressed >> i & 1U) && motion.dot(bumper_direction(i)) > kStandstill) return true;
  return false;
}

/// Returns the part of the motion that leads along the pressed bumpers, or zero if they block every
/// way.
Vec2 along_pressed(Vec2 motion, std::uint32_t pressed) noexcept {
  for (int i = 0; i < ControllerStatus::kBumpers; ++i) {
    if (!(pressed >> i & 1U)) continue;
    const double into = motion.dot(bumper_direction(i));
    if (into > 0) motion -= into * bumper_direction(i);
  }
  return towards_pressed(motion, pressed) ? Vec2(Vec2::Zero()) : motion;
}

}  // namespace

void MoveRobot::describe(Declaration<MoveRobot>& is) {
  is.help("Drives the robot as a force says: turns towards it, then drives along it.");
  is.reads(&MoveRobot::input_, "input_force",
           "direction and speed of the motion: length 1 is full speed");
  is.reads(&MoveRobot::shaft_, "shaft_variable",
           "where the robot is; the robot stands still while this is invalid");
  is.reads(&MoveRobot::mask_, "mask_variable",
           "pressed bumpers, bit 0 front, then counter-clockwise: no motion to their side")
      .optional();
  is.number(&MoveRobot::max_distance_m_, "max_distance_magnitude", unit::kCentimetre, 15,
            "how far a force of length 1 drives the robot unless it is renewed")
      .range(0.1, 1000);
  is.number(&MoveRobot::safety_range_rad_, "safety_range", unit::kDegree, 30,
            "if the force points farther off than this the robot turns in place first")
      .range(1, 90);
  is.flag(&MoveRobot::reverse_, "reverse", false,
          "whether it drives backwards along a force that points backwards, instead of turning");
  is.drives(kMotorDriveName);
  is.needs(kMotorDriveName);
  is.uses_devices(&MoveRobot::devices_);
}

void MoveRobot::run(const Tick& tick) {
  devices_->motor_drive.drive(command(tick));
}

DriveCommand MoveRobot::command(const Tick& tick) const noexcept {
  if (!acts(*input_, tick) || !shaft_->valid_at(tick.now)) return {};
  const std::uint32_t pressed = mask_ && mask_->valid_at(tick.now) ? mask_->value.value : 0;
  const Vec2 force = along_pressed(clipped(input_->value.value, 1), pressed);
  return force.norm() < kStandstill ? DriveCommand{} : follow(force, pressed);
}

DriveCommand MoveRobot::follow(const Vec2& force, std::uint32_t pressed) const noexcept {
  const MotorDrive& motors = devices_->motor_drive;
  const bool backwards = reverse_ && force.y() < 0;
  const double error_rad = bearing_rad(backwards ? Vec2(-force) : force);
  DriveCommand command;
  command.turn_rate_radps =
      motors.turning_speed_radps() * std::clamp(error_rad / safety_range_rad_, -1.0, 1.0);
  const bool aligned = std::abs(error_rad) <= safety_range_rad_;
  if (aligned && !towards_pressed({0, backwards ? -1.0 : 1.0}, pressed)) {
    command.speed_mps = motors.forward_speed_mps() * force.y();
    command.distance_limit_m = max_distance_m_ * force.norm();
  } else {
    command.angle_limit_rad = std::abs(error_rad);
  }
  return command;
}

}  // namespace galilean::robot
