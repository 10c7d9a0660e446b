// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "monitor/map/groups/robot_group.h"

namespace galilean::monitor {

/// The team, divided into groups.
///
///   law  A robot that is first heard joins the group with room whose robots are nearest, and stays
///        in it. Where no group is within kNear_m, the robot founds one. The first group takes any
///        robot while it has room, so that a team that fits into one group is never divided
class RobotGroups {
 public:
  static constexpr std::size_t kMaxRobots = 4;
  static constexpr double kNear_m = 8;

  /// `max_robots` is the size of a group.
  explicit RobotGroups(std::size_t max_robots) : max_robots_(max_robots) {}
  RobotGroups(const RobotGroups&) = delete;
  RobotGroups& operator=(const RobotGroups&) = delete;

  /// Sets the pose of a robot's odom frame in the map frame, as a person said it.
  void start_at(const std::string& robot, const Pose2& origin) { origins_.set(robot, origin); }

  [[nodiscard]] bool contains(const std::string& robot) const { return group_of_.contains(robot); }
  /// Returns the robot's group. Requires: contains(robot).
  [[nodiscard]] RobotGroup& of(const std::string& robot) const { return *group_of_.at(robot); }
  /// Returns the robot's group, and lets a new robot join one first. `in_odom` is its pose in its
  /// odom frame.
  RobotGroup& join(const std::string& robot, const Pose2& in_odom);

  /// Takes a robot out of its group and of the team. Returns the group if nobody is left in it: it
  /// is none of the team's any more. The first group stays, because its frame is the map's.
  /// Requires: contains(robot).
  [[nodiscard]] std::unique_ptr<RobotGroup> leave(const std::string& robot);

  /// Returns the other groups that may have landmarks within `within_m` of `at_m` (map frame). None
  /// if `group` is not localized.
  [[nodiscard]] std::vector<RobotGroup*> others_near(const RobotGroup& group, const Vec2& at_m,
                                                     double within_m) const;
  [[nodiscard]] const std::vector<std::unique_ptr<RobotGroup>>& all() const noexcept {
    return groups_;
  }
  /// Returns all robots with their groups.
  [[nodiscard]] const std::map<std::string, RobotGroup*>& robots() const noexcept {
    return group_of_;
  }
  /// Returns a number that no landmark has.
  [[nodiscard]] std::uint64_t next_id() noexcept { return ids_.next(); }

 private:
  [[nodiscard]] RobotGroup* nearest_with_room(const Vec2& at_m) const;

  std::size_t max_robots_;  ///< in a group
  OdomOrigins origins_;
  LandmarkIds ids_;
  std::vector<std::unique_ptr<RobotGroup>> groups_;
  std::map<std::string, RobotGroup*> group_of_;  ///< by robot
};

}  // namespace galilean::monitor
