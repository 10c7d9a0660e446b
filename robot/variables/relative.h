// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "core/schema/schema.h"
#include "core/variable/variable.h"

namespace galilean::robot {

/// A located object as the robot's centre sees it.
struct RelativeObject {
  Vec2 in_robot_m = Vec2::Zero();  ///< its centre, robot frame (x right, y forward)
  double distance_m = 0;           ///< from the robot's centre to its centre
  double radius_m = 0;
  double certainty = 0;  ///< of the less certain of object and shaft, more than 0

  /// Return unit vectors in the robot frame. At the object's very centre no direction is defined:
  /// away is then backwards, where the robot came from, and towards is zero.
  [[nodiscard]] Vec2 away() const noexcept;
  [[nodiscard]] Vec2 towards() const noexcept;
};

/// Returns where the object is, or nothing while either variable is invalid.
[[nodiscard]] std::optional<RelativeObject> relative_object(const Variable<Locate>& object,
                                                            const Variable<Shaft>& shaft,
                                                            Time now) noexcept;

/// Returns whether a force takes part in this tick. It does if it is valid, and was either written
/// in this tick or is a constant. A force whose schema did not run does not count.
[[nodiscard]] bool acts(const Variable<Force>& force, const Tick& tick) noexcept;

}  // namespace galilean::robot
