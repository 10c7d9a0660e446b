// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>

#include "monitor/map/landmarks/landmark_map.h"
#include "monitor/map/relocalization/heading_recovery.h"
#include "monitor/map/relocalization/landmark_merger.h"

namespace galilean::monitor {

/// A few robots that are estimated together, with all landmarks that they saw, in one joint
/// distribution. Its cost grows with the square of what is in it. A large team therefore has
/// several groups, which share landmarks (share_landmarks.h).
struct RobotGroup {
  RobotGroup(const OdomOrigins& origins, LandmarkIds& ids)
      : poses(joint, origins), landmarks(joint, poses, ids) {}
  RobotGroup(const RobotGroup&) = delete;
  RobotGroup& operator=(const RobotGroup&) = delete;

  /// Returns whether a landmark of the group may be within `within_m` of `at_m` (map frame).
  [[nodiscard]] bool reaches(const Vec2& at_m, double within_m) const {
    return extent_m.squaredExteriorDistance(at_m) < within_m * within_m;
  }

  JointGaussian joint;
  RobotPoses poses;
  LandmarkMap landmarks;
  HeadingRecovery heading_recovery{joint, poses, landmarks};
  LandmarkMerger merger{joint, poses, landmarks};
  Eigen::AlignedBox2d extent_m;  ///< of its landmarks, at the last update
  Time last_aligned{};
  /// Whether the group's position in the map frame is known: somebody said where one of its robots
  /// starts, or GroupLocalizer found it. Only then can its landmarks be compared with others'.
  bool is_localized = false;
};

}  // namespace galilean::monitor
