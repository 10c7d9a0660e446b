// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include "monitor/map/relocalization/labelled_point.h"
#include "monitor/map/relocalization/rigid_fit.h"

namespace galilean::monitor {

/// Finds the rigid transformation that corrects a robot's pose after it was wedged or pushed. All
/// that the robot sees then lies beside the known points by one turn about the robot and one shift.
///
///   law     Every two seen points are laid on every two known points of their labels that are as
///           far apart. The turn and shift on which most seen points agree is taken if at least
///           kLeastAgreeing agree, if they are most of the seen points, and if no other turn or
///           shift does nearly as well
///   units   turns up to kMaxTurn_rad, shifts of the robot up to `max_shift_m`
struct LocalRigidFit {
  static constexpr std::size_t kLeastAgreeing = 4;
  static constexpr double kMaxTurn_rad = 1.4;
  static constexpr double kMaxShift_m = 1.2;

  /// Returns the transformation from the seen to the known points, and the points that agree on it;
  /// nothing if it is not clear. All points and `robot_m` are in the map frame.
  [[nodiscard]] static std::optional<RigidFit> find(const std::vector<LabelledPoint>& seen,
                                                    const std::vector<LabelledPoint>& known,
                                                    const Vec2& robot_m,
                                                    double max_shift_m = kMaxShift_m);
};

}  // namespace galilean::monitor
