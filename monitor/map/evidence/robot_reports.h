// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/clock.h"
#include "core/wire/messages.h"
#include "monitor/map/evidence/contact_sensors.h"

namespace galilean::monitor {

/// The last reports of each robot: when it was heard, the state of its contact sensors, and the
/// obstacles that it touched.
class RobotReports {
 public:
  /// Records when a robot was heard by a message of which nothing else is kept here.
  void hear(const std::string& robot, Time now) { robots_[robot].heard = now; }
  void add(const msg::RobotState& state) { robots_[state.robot].sensors.update(state); }
  void add(const msg::Variables& variables, Time now);
  void add(const msg::Catalog& catalog, Time now);
  void add(const msg::Program& program, Time now);

  void forget(const std::string& robot) { robots_.erase(robot); }

  /// Returns the locate variables of the class "obstacle" that were written since the last call, in
  /// the robot's odom frame.
  [[nodiscard]] std::vector<msg::Variable> take_new_obstacles(const msg::Variables& variables);

  [[nodiscard]] bool is_touching(const std::string& robot, Time now) {
    return robots_[robot].sensors.is_touching(now);
  }
  [[nodiscard]] bool is_holding(const std::string& robot, Time now) {
    return robots_[robot].sensors.is_holding(now);
  }
  /// Returns when the robot was last heard. Requires: it was.
  [[nodiscard]] Time last_heard(const std::string& robot) const { return robots_.at(robot).heard; }

 private:
  struct Robot {
    Time heard{};
    ContactSensors sensors;
    Catalog catalog;
    std::optional<msg::Program> program;
    std::map<std::string, msg::Time> touched;  ///< obstacle variables, when each was last written
  };

  std::map<std::string, Robot> robots_;
};

}  // namespace galilean::monitor
