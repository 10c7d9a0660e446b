// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <string>
#include <vector>

#include "core/wire/messages.h"
#include "monitor/map/estimation/robot_poses.h"
#include "monitor/map/evidence/occupancy_grid_map.h"
#include "monitor/map/evidence/touch_evidence.h"

namespace galilean::monitor {

/// Draws into the occupancy grid what robots do and see, at the poses where they are estimated now.
/// A robot that neither drives nor turns gives no new evidence.
class OccupancyMapper {
 public:
  /// `robot` stands where `poses` says. Requires: poses.contains(robot).
  void add_robot(const std::string& robot, const RobotPoses& poses, Time now);
  /// Requires: poses.contains(frame.robot).
  void add_frame(const msg::Sightings& frame, const RobotPoses& poses);
  /// `robot` reports by a variable that it touched something. `others` are the places of all other
  /// robots. Requires: poses.contains(robot).
  void add_touch(const std::string& robot, const msg::Variable& obstacle, const RobotPoses& poses,
                 const std::vector<Gaussian2>& others, Time now);
  /// Forgets a robot that is gone. What it drew stays.
  void forget(const std::string& robot) {
    last_.erase(robot);
    touches_.forget(robot);
  }

  [[nodiscard]] const OccupancyGridMap& grid() const noexcept { return grid_; }

 private:
  /// Where a robot was when it last gave evidence.
  struct Last {
    Vec2 stood_m = Vec2::Constant(1e9);
    Pose2 looked{Vec2::Constant(1e9), 0};
  };

  OccupancyGridMap grid_;
  TouchEvidence touches_;
  std::map<std::string, Last> last_;  ///< by robot
};

}  // namespace galilean::monitor
