// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include "core/geometry.h"

namespace galilean::monitor {

/// The pose from which a robot's camera looked, and how long a landmark that it did not see there
/// counts as absent.
struct Viewpoint {
  Pose2 pose;                                            ///< in the map frame
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();  ///< of x, y [m] and heading [rad]
  double for_s = 0;  ///< 0: the robot recognizes nothing, and its pose may be wrong
};

}  // namespace galilean::monitor
