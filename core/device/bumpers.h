// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/device/comm_port.h"
#include "core/geometry.h"

namespace galilean {

/// The eight switches stand around the chassis at 45 degrees from one another, counter-clockwise:
/// 0 front, 1 front left, 2 left, 3 rear left, 4 rear, 5 rear right, 6 right, 7 front right.
/// Returns the counter-clockwise angle [rad] from straight ahead to bumper `index`.
[[nodiscard]] constexpr double bumper_angle_rad(int index) noexcept {
  return index * 2 * kPi / ControllerStatus::kBumpers;
}

/// Returns the direction in which a bumper lies, as a unit vector in the robot frame (x right, y
/// forward).
[[nodiscard]] inline Vec2 bumper_direction(int index) noexcept {
  return unit_vector(kPi / 2 + bumper_angle_rad(index));
}

}  // namespace galilean
