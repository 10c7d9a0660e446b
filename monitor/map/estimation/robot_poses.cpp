// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/map/estimation/robot_poses.h"

#include <utility>

#include "monitor/map/estimation/frames.h"
#include "monitor/map/estimation/motion_model.h"

namespace galilean::monitor {
namespace {

/// Standard deviations that are added for each metre between a robot's start and the pose that is
/// heard first, because its drive up to there was not heard.
constexpr double kUnheard_mpm = 0.1;
constexpr double kUnheard_radpm = 0.08;

/// A step that is longer than this speed and jitter allow is a jump of the odometer.
constexpr double kFastest_mps = 1.5;
constexpr double kJitter_m = 0.3;
/// Standard deviations of the movement of a robot while it was restarted.
constexpr double kSetDown_m = 0.05;
constexpr double kSetDown_rad = 0.1;

}  // namespace

void RobotPoses::add(const std::string& robot, const Pose2& in_odom, Time now) {
  OdomOrigins::Origin origin = origins_.of(robot);
  if (!origin.is_reference) {
    origin.position_m += kUnheard_mpm * in_odom.position_m.norm();
    origin.heading_rad += kUnheard_radpm * in_odom.position_m.norm();
  }
  const Pose2 at = in_map(origin.pose, in_odom);
  RobotVector mean = RobotVector::Zero();
  mean.head<3>() << at.position_m, at.heading_rad;
  robots_[robot] = {joint_.add(mean, initial_covariance(origin.position_m, origin.heading_rad)),
                    in_odom, now};
}

void RobotPoses::predict(const std::string& robot, const Pose2& in_odom, bool touching, Time now) {
  const auto known = robots_.find(robot);
  if (known == robots_.end()) return add(robot, in_odom, now);
  Robot& moving = known->second;
  OdometryStep step = step_between(moving.in_odom, in_odom);
  step.touching = touching;
  if (std::exchange(moving.touching, touching) != touching)
    joint_.reset_component(moving.block, kSlip, touching ? kTouchingSlip : 0,
                           touching ? kTouchingSlipVariance : 0);
  const double since_s = std::max(0.0, to_seconds(now - moving.last_predicted));
  moving.in_odom = in_odom;
  moving.last_predicted = now;
  if (step.by_m.norm() > kJitter_m + kFastest_mps * since_s) {
    RobotMatrix noise = initial_covariance(kSetDown_m, kSetDown_rad);
    noise.bottomRightCorner<4, 4>().setZero();
    joint_.inflate(moving.block, noise);
    return;
  }
  // A robot that stands still and touches nothing keeps its pose and its certainty.
  if (!touching && step.by_m.isZero(0) && step.turn_rad == 0) return;
  const PredictedMotion predicted = predict_motion(joint_.mean(moving.block), step);
  joint_.transform(moving.block, predicted.mean, predicted.jacobian, predicted.noise);
}

void RobotPoses::remove(const std::string& robot) {
  joint_.remove(block(robot));
  robots_.erase(robot);
}

Pose2 RobotPoses::pose(const std::string& robot) const {
  const auto mean = joint_.mean(block(robot));
  return {{mean[0], mean[1]}, wrap_angle(mean[2])};
}

Gaussian2 RobotPoses::position(const std::string& robot) const {
  return {joint_.mean(block(robot)).head<2>(),
          joint_.covariance(block(robot)).topLeftCorner<2, 2>()};
}

Gaussian2 RobotPoses::place(const std::string& robot, const Vec2& in_odom_m) const {
  const Vec2 at_m = in_map(odom_frame(robot), in_odom_m);
  const Vec2 lever_m = at_m - pose(robot).position_m;
  Eigen::Matrix<double, 2, 3> jacobian;
  jacobian << 1, 0, -lever_m.y(), 0, 1, lever_m.x();
  return {at_m,
          jacobian * joint_.covariance(block(robot)).topLeftCorner<3, 3>() * jacobian.transpose()};
}

Pose2 RobotPoses::odom_frame(const std::string& robot) const {
  const Pose2 in_map = pose(robot);
  const Pose2& in_odom = robots_.at(robot).in_odom;
  const double turn_rad = in_map.heading_rad - in_odom.heading_rad;
  return {in_map.position_m - rotated(in_odom.position_m, turn_rad), wrap_angle(turn_rad)};
}

}  // namespace galilean::monitor
