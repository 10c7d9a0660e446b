// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/map/groups/robot_groups.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "monitor/map/estimation/frames.h"

namespace galilean::monitor {
namespace {

double distance_m(const RobotGroup& group, const Vec2& at_m) {
  double nearest_m = std::numeric_limits<double>::infinity();
  for (const auto& [name, robot] : group.poses.all())
    nearest_m = std::min(nearest_m, (group.poses.pose(name).position_m - at_m).norm());
  return nearest_m;
}

}  // namespace

RobotGroup& RobotGroups::join(const std::string& robot, const Pose2& in_odom) {
  if (const auto known = group_of_.find(robot); known != group_of_.end()) return *known->second;
  origins_.hear(robot);
  RobotGroup* group = nearest_with_room(in_map(origins_.of(robot).pose, in_odom.position_m));
  if (!group) group = groups_.emplace_back(std::make_unique<RobotGroup>(origins_, ids_)).get();
  group->is_localized |= origins_.is_set(robot) || group == groups_.front().get();
  group_of_[robot] = group;
  return *group;
}

std::unique_ptr<RobotGroup> RobotGroups::leave(const std::string& robot) {
  RobotGroup* group = group_of_.at(robot);
  group_of_.erase(robot);
  if (group->poses.contains(robot)) group->poses.remove(robot);
  if (!group->poses.all().empty() || group == groups_.front().get()) return nullptr;
  const auto place =
      std::ranges::find_if(groups_, [&](const auto& each) { return each.get() == group; });
  auto left = std::move(*place);
  groups_.erase(place);
  return left;
}

std::vector<RobotGroup*> RobotGroups::others_near(const RobotGroup& group, const Vec2& at_m,
                                                  double within_m) const {
  std::vector<RobotGroup*> near;
  if (!group.is_localized) return near;
  for (const auto& other : groups_)
    if (other.get() != &group && other->is_localized && other->reaches(at_m, within_m))
      near.push_back(other.get());
  return near;
}

RobotGroup* RobotGroups::nearest_with_room(const Vec2& at_m) const {
  RobotGroup* nearest = nullptr;
  double nearest_m = kNear_m;
  for (const auto& group : groups_) {
    const auto is_in_group = [&](const auto& robot) { return robot.second == group.get(); };
    const auto robots = static_cast<std::size_t>(std::ranges::count_if(group_of_, is_in_group));
    if (robots >= max_robots_) continue;
    if (group == groups_.front()) return group.get();
    const double away_m = distance_m(*group, at_m);
    if (away_m >= nearest_m) continue;
    nearest = group.get();
    nearest_m = away_m;
  }
  return nearest;
}

}  // namespace galilean::monitor
