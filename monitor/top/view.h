// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/geometry.h"
#include "monitor/team/robot.h"
#include "monitor/top/knowledge.h"

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
  double certainty = 0;  ///< 0: not valid
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

/// One picture of the team, ready to be laid out: no clock and no messages behind it.
struct View {
  std::vector<ShownRobot> robots;
  std::size_t chosen = 0;
  std::vector<ShownState> states;        ///< of the chosen robot's program
  std::vector<ShownVariable> variables;  ///< of the chosen robot
  std::optional<msg::Score> score;
  std::string map_title;
  std::vector<ShownObject> objects;
  std::vector<ShownPose> poses;
  std::optional<msg::OccupancyGrid> floor;  ///< in the frame of the objects
  std::string notice;
};

/// `chosen`: a robot's name; the first robot where there is none of that name. Without a monitor's
/// map the chosen robot's own frame is shown: no two robots' frames are the same.
[[nodiscard]] View make_view(const Knowledge& knowledge, const Clock& clock,
                             const std::string& chosen);

/// The first letter of the name that no robot before has.
[[nodiscard]] char letter_for(const std::string& name, const std::vector<ShownRobot>& others);

}  // namespace galilean::monitor::top
