// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/map/evidence/occupancy_mapper.h"

#include <cmath>

#include "monitor/map/estimation/frames.h"

namespace galilean::monitor {
namespace {

constexpr double kStep_m = 0.05;
constexpr double kTurn_rad = 0.1;
constexpr double kMaxFloorRange_m =
    4;  ///< the range of an object further away is too uncertain to end a line of sight

}  // namespace

void OccupancyMapper::add_robot(const std::string& robot, const RobotPoses& poses) {
  const Vec2 at_m = poses.pose(robot).position_m;
  Vec2& stood_m = last_[robot].stood_m;
  if ((at_m - stood_m).norm() < kStep_m) return;
  stood_m = at_m;
  grid_.add_robot(at_m);
}

void OccupancyMapper::add_frame(const msg::Sightings& frame, const RobotPoses& poses) {
  const Pose2 pose = poses.pose(frame.robot), odom = poses.odom_frame(frame.robot);
  Pose2& last = last_[frame.robot].looked;
  if ((pose.position_m - last.position_m).norm() < kStep_m &&
      std::abs(wrap_angle(pose.heading_rad - last.heading_rad)) < kTurn_rad)
    return;
  last = pose;
  OccupancyGridMap::View view{pose.position_m, pose.heading_rad, frame.view_angle_rad, {}};
  for (const auto& sighting : frame.items)
    if (sighting.range_m < kMaxFloorRange_m)
      view.objects_m.push_back(in_map(odom, Vec2(sighting.x_m, sighting.y_m)));
  grid_.add_view(view);
}

}  // namespace galilean::monitor
