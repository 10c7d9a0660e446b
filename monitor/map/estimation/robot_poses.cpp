#include "monitor/map/estimation/robot_poses.h"

#include <utility>

#include "monitor/map/estimation/frames.h"
#include "monitor/map/estimation/robot_motion.h"

namespace galilean::monitor {
namespace {

/// Dead reckoning before it was first heard, a metre from its start.
constexpr double kUnheard_mpm = 0.1;
constexpr double kUnheard_radpm = 0.08;

constexpr double kFastest_mps = 1.5;
constexpr double kJitter_m = 0.3;
constexpr double kSetDown_m = 0.05;  ///< what a restart may have moved a robot
constexpr double kSetDown_rad = 0.1;

}  // namespace

void RobotPoses::place(const std::string& robot, const Pose2& in_odom, Time now) {
  Starts::Start start = starts_.of(robot);
  if (!start.is_reference) {
    start.position_m += kUnheard_mpm * in_odom.position_m.norm();
    start.heading_rad += kUnheard_radpm * in_odom.position_m.norm();
  }
  const Pose2 at = in_map(start.origin, in_odom);
  RobotVector mean = RobotVector::Zero();
  mean.head<3>() << at.position_m, at.heading_rad;
  robots_[robot] = {joint_.add(mean, start_covariance(start.position_m, start.heading_rad)),
                    in_odom, now};
}

void RobotPoses::move(const std::string& robot, const Pose2& in_odom, bool touching, Time now) {
  const auto known = robots_.find(robot);
  if (known == robots_.end()) return place(robot, in_odom, now);
  Robot& moving = known->second;
  OdometryStep step = step_between(moving.in_odom, in_odom);
  step.touching = touching;
  if (std::exchange(moving.touching, touching) != touching)
    joint_.replace(moving.part, kSlip, touching ? kTouchingSlip : 0, touching ? kTouchingSlip2 : 0);
  const double since_s = std::max(0.0, to_seconds(now - moving.moved));
  moving.in_odom = in_odom;
  moving.moved = now;
  if (step.by_m.norm() > kJitter_m + kFastest_mps * since_s) {
    RobotMatrix noise = start_covariance(kSetDown_m, kSetDown_rad);
    noise.bottomRightCorner<4, 4>().setZero();
    joint_.blur(moving.part, noise);
    return;
  }
  if (!touching && step.by_m.isZero(0) && step.turn_rad == 0) return;  // neither moved nor unsurer
  const Moved now_at = galilean::monitor::moved(joint_.mean(moving.part), step);
  joint_.move(moving.part, now_at.mean, now_at.jacobian, now_at.noise);
}

Pose2 RobotPoses::pose(const std::string& robot) const {
  const auto mean = joint_.mean(part(robot));
  return {{mean[0], mean[1]}, wrap_angle(mean[2])};
}

Gaussian2 RobotPoses::position(const std::string& robot) const {
  return {joint_.mean(part(robot)).head<2>(), joint_.covariance(part(robot)).topLeftCorner<2, 2>()};
}

Pose2 RobotPoses::frame(const std::string& robot) const {
  const Pose2 in_map = pose(robot);
  const Pose2& in_odom = robots_.at(robot).in_odom;
  const double turn_rad = in_map.heading_rad - in_odom.heading_rad;
  return {in_map.position_m - rotated(in_odom.position_m, turn_rad), wrap_angle(turn_rad)};
}

}  // namespace galilean::monitor
