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

/// Returns whether a robot moved so far that what it does and sees is new.
bool has_moved(const Pose2& from, const Pose2& to) {
  return (to.position_m - from.position_m).norm() >= kStep_m ||
         std::abs(wrap_angle(to.heading_rad - from.heading_rad)) >= kTurn_rad;
}

/// Returns how far an object reaches around its centre.
double radius_m(const std::string& object_class) {
  if (object_class == "basket") return 0.15;
  return object_class == "robot" ? 0.20 : 0.04;
}

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
  add_settled(robot, poses, now);
  const Pose2 pose = poses.pose(robot);
  Last& last = last_[robot];
  if (!has_moved(last.stood, pose)) return;
  last.stood = pose;
  grid_.add_robot(poses.position(robot), pose.heading_rad, last.stands_on);
}

void OccupancyMapper::add_touch(const std::string& robot, const msg::Variable& obstacle,
                                const RobotPoses& poses, const std::vector<Gaussian2>& others,
                                Time now) {
  const Vec2 in_odom_m(obstacle.values[0], obstacle.values[1]);
  const Gaussian2 touched = poses.place(robot, in_odom_m);
  const bool is_new = touches_.is_new(robot, obstacle.name, in_odom_m, now);
  if (!is_new || robot_at(touched, others)) return;
  pending_.add(robot, in_odom_m, poses, now);
  add_settled(robot, poses, now);
}

void OccupancyMapper::add_settled(const std::string& robot, const RobotPoses& poses, Time now) {
  for (const Gaussian2& touched : pending_.take_settled(robot, poses, now))
    grid_.add_touch(touched);
}

void OccupancyMapper::add_frame(const msg::Sightings& frame, const RobotPoses& poses) {
  const Pose2 pose = poses.pose(frame.robot), odom = poses.odom_frame(frame.robot);
  Pose2& last = last_[frame.robot].looked;
  if (!has_moved(last, pose)) return;
  last = pose;
  OccupancyGridMap::View view{pose.position_m, pose.heading_rad, frame.view_angle_rad, {}};
  view.deviation_m = std::sqrt(poses.position(frame.robot).covariance_m2.trace() / 2);
  for (const auto& sighting : frame.items)
    if (sighting.range_m < kMaxFloorRange_m)
      view.objects.push_back(
          {in_map(odom, Vec2(sighting.x_m, sighting.y_m)), radius_m(sighting.object_class)});
  grid_.add_view(view);
}

}  // namespace galilean::monitor
