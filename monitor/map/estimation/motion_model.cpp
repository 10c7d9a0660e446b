// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/map/estimation/motion_model.h"

#include <cmath>

#include "monitor/map/estimation/gaussian.h"

namespace galilean::monitor {
namespace {

/// Variances for each metre driven and each radian turned. Treads scrub, so they lose more in
/// turns.
constexpr double kAlong_m2pm = 2e-4;
constexpr double kAcross_m2pm = 1e-4;
constexpr double kHeading_rad2pm = 1e-2;
constexpr double kPosition_m2prad = 5e-5;
constexpr double kHeading_rad2prad = 1.5e-3;

/// Standard deviations of a step while something is at the bumpers: the share of the step that is
/// lost, and the distance and the angle that the robot is pushed.
constexpr double kLost = 0.5;
constexpr double kPushed_m = 0.004;
constexpr double kPushed_rad = 0.01;
constexpr double kSlipChange = 0.05;

/// Standard deviations of the odometer's systematic errors, which differ between robots.
constexpr double kScale = 0.015;
constexpr double kTurnScale = 0.02;
constexpr double kCurvature_radpm = 0.01;

}  // namespace

OdometryStep step_between(const Pose2& from_odom, const Pose2& to_odom) {
  return {rotated(to_odom.position_m - from_odom.position_m, -from_odom.heading_rad),
          wrap_angle(to_odom.heading_rad - from_odom.heading_rad)};
}

PredictedMotion predict_motion(const RobotVector& robot, const OdometryStep& step) {
  const double forward_m = step.by_m.x();
  const Vec2 by = rotated(step.by_m, robot[2]);
  const double scale = 1 + robot[3];
  PredictedMotion result;
  result.mean = robot;
  result.mean.head<2>() += scale * by;
  result.mean[2] += (1 + robot[4] - robot[kSlip]) * step.turn_rad + robot[5] * forward_m;

  result.jacobian.setIdentity();
  result.jacobian(0, 2) = -scale * by.y();
  result.jacobian(1, 2) = scale * by.x();
  result.jacobian.block<2, 1>(0, 3) = by;
  result.jacobian(2, 4) = step.turn_rad;
  result.jacobian(2, 5) = forward_m;
  result.jacobian(2, kSlip) = -step.turn_rad;

  const double way_m = step.by_m.norm(), angle_rad = std::abs(step.turn_rad);
  const Vec2 position(kAlong_m2pm * way_m + kPosition_m2prad * angle_rad,
                      kAcross_m2pm * way_m + kPosition_m2prad * angle_rad);
  const Mat2 turn = rotation_matrix(robot[2]);
  result.noise.setZero();
  result.noise.topLeftCorner<2, 2>() = turn * position.asDiagonal() * turn.transpose();
  result.noise(2, 2) = kHeading_rad2pm * way_m + kHeading_rad2prad * angle_rad;
  if (step.touching) {
    result.noise.topLeftCorner<2, 2>() +=
        kLost * kLost * by * by.transpose() + kPushed_m * kPushed_m * Mat2::Identity();
    result.noise(2, 2) += kLost * kLost * angle_rad * angle_rad + kPushed_rad * kPushed_rad;
    result.noise(kSlip, kSlip) = kSlipChange * kSlipChange;
  }
  return result;
}

RobotMatrix initial_covariance(double position_m, double heading_rad) {
  RobotVector deviations;
  deviations << position_m, position_m, heading_rad, kScale, kTurnScale, kCurvature_radpm, 0;
  return deviations.cwiseAbs2().asDiagonal();
}

}  // namespace galilean::monitor
