// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include "core/geometry.h"

namespace galilean::monitor {

/// The state of one robot: its pose in the map frame, and what its odometer errs by.
///   0, 1  x, y [m]
///   2     heading [rad], not wrapped
///   3     scale [m/m]: how much further it drives than its odometer says
///   4     turn scale [rad/rad]: how much further it turns
///   5     curvature [rad/m]: how much it turns with each metre that it drives
///   6     slip [rad/rad]: which share of a counted turn is lost while it touches something
using RobotVector = Eigen::Matrix<double, 7, 1>;
using RobotMatrix = Eigen::Matrix<double, 7, 7>;

/// The slip is one unknown for as long as the robot touches something, because a wedged robot turns
/// its treads for seconds and stands still. Otherwise it is 0.
inline constexpr Eigen::Index kSlip = 6;
inline constexpr double kTouchingSlip = 0.1;
inline constexpr double kTouchingSlipVariance = 0.2 * 0.2;

/// A step of dead reckoning, in the robot frame at the beginning of the step (x forward, y left).
struct OdometryStep {
  Vec2 by_m = Vec2::Zero();
  double turn_rad = 0;
  bool touching = false;  ///< whether something is at the robot's bumpers
};
/// Returns the step between two poses in the odom frame.
[[nodiscard]] OdometryStep step_between(const Pose2& from_odom, const Pose2& to_odom);

/// The result of the motion model, for JointGaussian::transform.
struct PredictedMotion {
  RobotVector mean;
  RobotMatrix jacobian;  ///< of the new state by the old one
  RobotMatrix noise;     ///< covariance
};

/// Applies a step of dead reckoning to a robot's state. The true step is
///   (1 + scale) · by,  (1 + turn scale - slip) · turn + curvature · forward,
/// plus noise whose variance grows with the distance driven and the angle turned.
[[nodiscard]] PredictedMotion predict_motion(const RobotVector& robot, const OdometryStep& step);

/// Returns the covariance of a robot whose pose has these standard deviations, and whose odometer
/// errs as treads on carpet do.
[[nodiscard]] RobotMatrix initial_covariance(double position_m, double heading_rad);

}  // namespace galilean::monitor
