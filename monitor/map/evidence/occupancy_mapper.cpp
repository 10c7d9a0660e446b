// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/map/evidence/occupancy_mapper.h"

#include <algorithm>
#include <cmath>

#include "monitor/map/estimation/frames.h"

namespace galilean::monitor {
namespace {

constexpr double kStep_m = 0.05;
constexpr double kTurn_rad = 0.1;
constexpr double kMaxFloorRange_m =
    4;  ///< the range of an object further away is too uncertain to end a line of sight

/// A touch so near to another robot's centre is with that robot, whose hull ends before this.
constexpr double kRobotReach_m = 0.30;

/// Returns whether one of the robots may stand where something was touched.
bool robot_at(const Gaussian2& touched, const std::vector<Gaussian2>& robots) {
  return std::ranges::any_of(robots, [&](const Gaussian2& robot) {
    const Mat2 covariance_m2 = touched.covariance_m2 + robot.covariance_m2;
    return (touched.mean_m - robot.mean_m).norm() <
           kRobotReach_m + std::sqrt(covariance_m2.trace() / 2);
  });
}

}  // namespace

void OccupancyMapper::add_robot(const std::string& robot, const RobotPoses& poses, Time now) {
  touches_.note_pose(robot, poses.all().at(robot).in_odom, now);
  const Gaussian2 at = poses.position(robot);
  Vec2& stood_m = last_[robot].stood_m;
  if ((at.mean_m - stood_m).norm() < kStep_m) return;
  stood_m = at.mean_m;
  grid_.add_robot(at, poses.pose(robot).heading_rad);
}

void OccupancyMapper::add_touch(const std::string& robot, const msg::Variable& obstacle,
                                const RobotPoses& poses, const std::vector<Gaussian2>& others,
                                Time now) {
  const Vec2 in_odom_m(obstacle.values[0], obstacle.values[1]);
  const Gaussian2 touched = poses.place(robot, in_odom_m);
  const bool is_new = touches_.is_new(robot, obstacle.name, in_odom_m, now);
  if (is_new && !robot_at(touched, others)) grid_.add_touch(touched);
}

void OccupancyMapper::add_frame(const msg::Sightings& frame, const RobotPoses& poses) {
  const Pose2 pose = poses.pose(frame.robot), odom = poses.odom_frame(frame.robot);
  Pose2& last = last_[frame.robot].looked;
  if ((pose.position_m - last.position_m).norm() < kStep_m &&
      std::abs(wrap_angle(pose.heading_rad - last.heading_rad)) < kTurn_rad)
    return;
  last = pose;
  OccupancyGridMap::View view{pose.position_m, pose.heading_rad, frame.view_angle_rad, {}};
  view.deviation_m = std::sqrt(poses.position(frame.robot).covariance_m2.trace() / 2);
  for (const auto& sighting : frame.items)
    if (sighting.range_m < kMaxFloorRange_m)
      view.objects_m.push_back(in_map(odom, Vec2(sighting.x_m, sighting.y_m)));
  grid_.add_view(view);
}

}  // namespace galilean::monitor
