// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/map/evidence/pending_touches.h"

#include <cmath>
#include <iterator>
#include <utility>

namespace galilean::monitor {
namespace {

/// Returns how uncertain a point is that a robot at `from` has at `to_m`, in the frame of both.
Mat2 covariance_at(const Vec2& to_m, const Pose2& from, const RobotMatrix& covariance) {
  const Vec2 lever_m = to_m - from.position_m;
  Eigen::Matrix<double, 2, 3> jacobian;
  jacobian << 1, 0, -lever_m.y(), 0, 1, lever_m.x();
  return jacobian * covariance.topLeftCorner<3, 3>() * jacobian.transpose();
}

/// The slip is an unknown while the robot touches something; see RobotPoses.
void set_slip(RobotMatrix& covariance, bool touching) {
  if (touching == (covariance(kSlip, kSlip) > 0)) return;
  covariance.row(kSlip).setZero();
  covariance.col(kSlip).setZero();
  if (touching) covariance(kSlip, kSlip) = kTouchingSlipVariance;
}

}  // namespace

void PendingTouches::add(const std::string& robot, const Vec2& in_odom_m, const RobotPoses& poses,
                         Time now) {
  Robot& touching = robots_[robot];
  touching.in_odom = poses.all().at(robot).in_odom;
  touching.touches.push_back(
      {in_odom_m, initial_covariance(0, 0), poses.place(robot, in_odom_m), now});
}

std::vector<Gaussian2> PendingTouches::take_settled(const std::string& robot,
                                                    const RobotPoses& poses, Time now) {
  const auto known = robots_.find(robot);
  if (known == robots_.end()) return {};
  move(known->second, poses.all().at(robot));
  std::vector<Gaussian2> settled;
  std::erase_if(known->second.touches, [&](Touch& touch) {
    if (!look_again(touch, robot, poses, now)) return false;
    settled.push_back(touch.best);
    return true;
  });
  return settled;
}

void PendingTouches::move(Robot& robot, const RobotPoses::Robot& to) {
  OdometryStep step = step_between(robot.in_odom, to.in_odom);
  step.touching = to.touching;
  RobotVector before = RobotVector::Zero();
  before.head<3>() << robot.in_odom.position_m, robot.in_odom.heading_rad;
  robot.in_odom = to.in_odom;
  const PredictedMotion predicted = predict_motion(before, step);
  for (Touch& touch : robot.touches) {
    set_slip(touch.way, step.touching);
    touch.way = predicted.jacobian * touch.way * predicted.jacobian.transpose() + predicted.noise;
  }
}

bool PendingTouches::look_again(Touch& touch, const std::string& robot, const RobotPoses& poses,
                                Time now) {
  const Pose2& in_odom = poses.all().at(robot).in_odom;
  const Mat2 way_m2 = covariance_at(touch.in_odom_m, in_odom, touch.way);
  Gaussian2 place = poses.place(robot, touch.in_odom_m);
  const Mat2 turn = rotation_matrix(poses.odom_frame(robot).heading_rad);
  place.covariance_m2 += turn * way_m2 * turn.transpose();
  if (place.covariance_m2.trace() < touch.best.covariance_m2.trace()) touch.best = place;
  const double best_m2 = touch.best.covariance_m2.trace();
  return best_m2 < 2 * kKnown_m * kKnown_m || way_m2.trace() > best_m2 || now - touch.at > kLongest;
}

}  // namespace galilean::monitor
