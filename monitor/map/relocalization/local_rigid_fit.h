// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include "monitor/map/relocalization/labelled_point.h"
#include "monitor/map/relocalization/rigid_fit.h"

namespace galilean::monitor {

/// The rigid transformation that puts a robot back where it is, after it was wedged or pushed. What
/// it sees then lies beside what is known by one and the same turn about the robot and one shift.
///
///   law     Every two seen points are laid on every two known points of their labels that are as
///           far apart. The turn and shift on which most seen points agree counts if at least
///           kLeastAgreeing do, if those are most of what was seen, and if no other turn or shift
///           does nearly as well
///   units   turns up to kMaxTurn_rad, shifts of the robot up to `max_shift_m`
struct LocalRigidFit {
  static constexpr std::size_t kLeastAgreeing = 4;
  static constexpr double kMaxTurn_rad = 1.4;
  static constexpr double kMaxShift_m = 1.2;

  /// Returns the transformation from where points were seen to where they are known, and which
  /// points agree. All points and `robot_m` are in the map frame. Nothing if it is not clear.
  [[nodiscard]] static std::optional<RigidFit> find(const std::vector<LabelledPoint>& seen,
                                                    const std::vector<LabelledPoint>& known,
                                                    const Vec2& robot_m,
                                                    double max_shift_m = kMaxShift_m);
};

}  // namespace galilean::monitor
