// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/geometry.h"
#include "monitor/team/robot.h"
#include "monitor/top/model/dashboard_model.h"

namespace galilean::monitor::top {

struct ShownRobot {
  char letter = '?';
  RobotStatus status;
};
struct ShownState {
  std::string name;
  bool current = false;
};
struct ShownVariable {
  std::string name;
  std::string value;
  double certainty = 0;  ///< from 0 to 1; 0 if the variable is invalid
};
struct ShownObject {
  std::string object_class;
  Vec2 position_m;
  double certainty = 0;
};
struct ShownPose {
  std::size_t robot = 0;  ///< index into View::robots
  Pose2 pose;
};

/// A snapshot of the team that can be drawn without a clock and without the messages behind it.
struct View {
  std::vector<ShownRobot> robots;
  std::size_t chosen = 0;
  std::vector<ShownState> states;        ///< the states of the chosen robot's program
  std::vector<ShownVariable> variables;  ///< the chosen robot's variables
  std::optional<msg::Score> score;
  std::string map_title;
  std::vector<ShownObject> objects;
  std::vector<ShownPose> poses;
  std::optional<msg::OccupancyGrid> floor;  ///< the occupancy grid, in the frame of the objects
  std::string notice;
};

/// Returns a snapshot with the robot named `chosen` as the chosen one, or the first robot if there
/// is none of that name. Without a monitor's map, only the chosen robot is placed, in its own odom
/// frame, because the robots' odom frames differ.
[[nodiscard]] View make_view(const DashboardModel& model, const Clock& clock,
                             const std::string& chosen);

/// Returns the first letter or digit of the name that none of `others` has, else any free letter or
/// digit, else '?'.
[[nodiscard]] char letter_for(const std::string& name, const std::vector<ShownRobot>& others);

}  // namespace galilean::monitor::top
