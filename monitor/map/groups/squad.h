#pragma once

#include <Eigen/Geometry>

#include "monitor/map/relocalization/orientation.h"
#include "monitor/map/relocalization/same_things.h"

namespace galilean::monitor {

/// A few robots that are estimated together, with all that they saw, in one joint distribution.
/// Its cost grows with the square of what is in it; therefore a large team has many, which learn
/// from one another (neighbours.h).
struct Squad {
  Squad(const Starts& starts, LandmarkIds& ids)
      : poses(joint, starts), landmarks(joint, poses, ids) {}
  Squad(const Squad&) = delete;
  Squad& operator=(const Squad&) = delete;

  /// Something it noted may be so near.
  [[nodiscard]] bool reaches(const Vec2& at_m, double within_m) const {
    return extent_m.squaredExteriorDistance(at_m) < within_m * within_m;
  }

  JointGaussian joint;
  RobotPoses poses;
  LandmarkMap landmarks;
  Orientation orientation{joint, poses, landmarks};
  SameThings same_things{joint, poses, landmarks};
  Eigen::AlignedBox2d extent_m;  ///< of its landmarks, at the last update
  Time aligned{};
  /// Somebody said where one of its robots starts, or it was found: what it notes can be compared
  /// with what others do.
  bool placed = false;
};

}  // namespace galilean::monitor
