#pragma once

#include <Eigen/Core>

#include "core/geometry.h"

namespace galilean::monitor {

/// Where a robot is in the map frame and how its odometer errs:
///   x, y [m], heading [rad], scale [m/m], turn scale [rad/rad], curvature [rad/m], slip [rad/rad]
using RobotVector = Eigen::Matrix<double, 7, 1>;
using RobotMatrix = Eigen::Matrix<double, 7, 7>;

/// A robot that is wedged turns its treads for seconds and stands still. How much of its turning is
/// lost is one unknown for as long as it touches something, and 0 otherwise.
inline constexpr Eigen::Index kSlip = 6;
inline constexpr double kTouchingSlip = 0.1;
inline constexpr double kTouchingSlip2 = 0.2 * 0.2;

/// What dead reckoning says of a step, in the robot's directions at its beginning.
struct OdometryStep {
  Vec2 by_m = Vec2::Zero();
  double turn_rad = 0;
  bool touching = false;  ///< something was at the robot's bumpers
};
[[nodiscard]] OdometryStep step_between(const Pose2& from_odom, const Pose2& to_odom);

struct Moved {
  RobotVector mean;
  RobotMatrix jacobian;
  RobotMatrix noise;
};

/// Dead reckoning as a random walk: the true step is
///   (1 + scale) · by,  (1 + turn scale - slip) · turn + curvature · forward,
/// and noise whose variance grows with the way driven and the angle turned.
[[nodiscard]] Moved moved(const RobotVector& robot, const OdometryStep& step);

/// `position_m` and `heading_rad` are as unsure as said; the odometer as treads on carpet are.
[[nodiscard]] RobotMatrix start_covariance(double position_m, double heading_rad);

}  // namespace galilean::monitor
