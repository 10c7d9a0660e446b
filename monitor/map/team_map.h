// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "core/clock.h"
#include "core/wire/messages.h"
#include "monitor/map/evidence/carried_objects.h"
#include "monitor/map/evidence/occupancy_mapper.h"
#include "monitor/map/evidence/robot_reports.h"
#include "monitor/map/groups/group_localizer.h"

namespace galilean::monitor {

/// The team's map: robots, landmarks and free floor in one frame, "map". Robots and landmarks are
/// estimated jointly, a few robots at a time (RobotGroup). The occupancy grid is drawn from the
/// estimated poses. docs/MAP.md explains how.
///
/// The map is a pure function of its inputs: messages and the time go in, messages come out.
class TeamMap {
 public:
  /// A robot that was not heard for `silent_after` is published as silent. At most `group_size`
  /// robots are estimated jointly.
  explicit TeamMap(Duration silent_after, std::size_t group_size = RobotGroups::kMaxRobots)
      : silent_after_(silent_after), groups_(group_size) {}
  TeamMap(const TeamMap&) = delete;
  TeamMap& operator=(const TeamMap&) = delete;

  /// Sets the pose of a robot's odom frame in the map frame. Requires: before the robot is heard.
  void start_at(const std::string& robot, const Pose2& origin) { groups_.start_at(robot, origin); }

  /// Adds what a robot said at `now`. Poses that are not finite are ignored.
  void add(const msg::RobotState& state, Time now);
  void add(const msg::Sightings& frame, Time now);
  void add(const msg::Variables& variables, Time now);
  void add(const msg::Catalog& catalog, Time now) { reports_.add(catalog, now); }
  void add(const msg::Program& program, Time now) { reports_.add(program, now); }

  /// Forgets a robot that is gone. The floor and the landmarks that it saw stay, but for landmarks
  /// that only its group knew of which it was the last robot.
  void forget(const std::string& robot);

  /// Lets certainties decay, merges duplicates, shares landmarks between groups, and picks up and
  /// puts down the objects that robots carry. Call it before you ask for the messages.
  void update(Time now);
  /// `stamp_ns` is the instant `now` since the Unix epoch.
  [[nodiscard]] msg::ObjectMap objects(Time now, std::int64_t stamp_ns) const;
  [[nodiscard]] msg::TFMessage transforms(std::int64_t stamp_ns) const;
  [[nodiscard]] const OccupancyGridMap& occupancy() const noexcept { return occupancy_.grid(); }

 private:
  /// Predicts the robot's pose. Returns false if the message cannot be used.
  bool predict(const std::string& robot, const Pose2& in_odom, Time now);
  void add_obstacle(const std::string& robot, const msg::Variable& obstacle, Time now);
  [[nodiscard]] msg::Sightings without_carried(const msg::Sightings& frame) const;
  [[nodiscard]] std::vector<Gaussian2> robots_of_others(const RobotGroup& group) const;
  [[nodiscard]] std::vector<Gaussian2> robots_but(const std::string& robot) const;
  void align(Time now);
  void clear_footprint(const std::string& robot);

  Duration silent_after_;
  RobotReports reports_;
  RobotGroups groups_;
  GroupLocalizer localizer_{groups_};
  CarriedObjects carried_{groups_};
  PublishedLandmarks published_;  ///< as of the last update
  OccupancyMapper occupancy_;
};

}  // namespace galilean::monitor
