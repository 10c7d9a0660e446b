// SPDX-License-Identifier: BSD-3-Clause
#include "robot/devices/motor_drive.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "robot/firmware/hardware.h"

namespace galilean::robot {
namespace {

/// Returns the seconds until the first limit is reached, or infinity without a limit.
double seconds_to_limit(const DriveCommand& command) {
  double seconds = std::numeric_limits<double>::infinity();
  if (command.distance_limit_m > 0 && command.speed_mps != 0)
    seconds = command.distance_limit_m / std::fabs(command.speed_mps);
  if (command.angle_limit_rad > 0 && command.turn_rate_radps != 0)
    seconds = std::min(seconds, command.angle_limit_rad / std::fabs(command.turn_rate_radps));
  return seconds;
}

std::int16_t whole_speed(double counts_s) {
  constexpr double highest = std::numeric_limits<std::int16_t>::max();
  return static_cast<std::int16_t>(std::lround(std::clamp(counts_s, -highest, highest)));
}

/// Returns the limit in whole counts. 0 means "no limit" to the board, so that a limit below half a
/// count becomes one count.
std::uint32_t whole_limit(double counts) {
  constexpr double highest = std::numeric_limits<std::int32_t>::max();
  return std::isfinite(counts)
             ? static_cast<std::uint32_t>(std::lround(std::clamp(counts, 1.0, highest)))
             : 0;
}

bool is_finite(const DriveCommand& c) {
  return std::isfinite(c.speed_mps) && std::isfinite(c.turn_rate_radps);
}

}  // namespace

WheelDrive::WheelDrive(MicrocontrollerLink& link, const MotorDriveSettings& settings)
    : link_(link) {
  configure(settings);
}

void WheelDrive::configure(const MotorDriveSettings& settings) noexcept {
  counts_per_m_ = settings.ticks_per_m * firmware::kCountsPerTick;
  motion_ = settings.motion();
  link_.configure({settings.parameters(), settings.ticks_per_m});
}

std::string WheelDrive::problem() const {
  const std::string cause = link_.problem();
  return cause.empty() ? cause : "The motors cannot be reached. " + cause;
}

void WheelDrive::drive(const DriveCommand& command) noexcept {
  if (!is_finite(command)) return stop();
  const double turning_mps = command.turn_rate_radps * motion_.turn_radius_m;
  const double left_counts_s = (command.speed_mps - turning_mps) * counts_per_m_;
  const double right_counts_s = (command.speed_mps + turning_mps) * counts_per_m_;
  const double seconds = seconds_to_limit(command);
  link_.drive({.left_speed_counts_s = whole_speed(left_counts_s),
               .right_speed_counts_s = whole_speed(right_counts_s),
               .left_limit_counts = whole_limit(std::fabs(left_counts_s) * seconds),
               .right_limit_counts = whole_limit(std::fabs(right_counts_s) * seconds)});
}

}  // namespace galilean::robot
