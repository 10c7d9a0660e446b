// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/geometry.h"
#include "monitor/team/robot.h"
#include "monitor/top/model/alarms.h"
#include "monitor/top/model/curves.h"
#include "monitor/top/model/dashboard_model.h"
#include "monitor/top/model/floor.h"

namespace galilean::monitor::top {

struct ShownRobot {
  std::string letter = "?";
  std::size_t number = 0;  ///< of its colour
  RobotStatus status;
  bool has_unseen_alarm = false;
  bool is_stopped = false;      ///< by a break point or the end of a step
  bool waits = false;           ///< at a lock
  std::string steered_by = {};  ///< another operator's name; empty: nobody else holds it
};
/// What break points do where a state is entered or a transition fires.
enum class BreakMark : std::uint8_t { kNone, kStop, kStopTeam, kLock };
/// A condition that leads out of the present state.
struct ShownCondition {
  std::string text;  ///< "bumpers[1] = 1"
  std::string to_state;
  std::optional<bool> bit;  ///< as it is now; none while its variable is invalid
  bool wanted = true;       ///< the bit that it waits for
  BreakMark mark = BreakMark::kNone;

  [[nodiscard]] bool holds() const noexcept { return bit == wanted; }
};
struct ShownState {
  std::string name;
  bool current = false;
  bool before = false;                ///< the robot came from it
  BreakMark mark = BreakMark::kNone;  ///< of those that stop whoever enters it
  bool chosen = false;                ///< keys set break points there
};
struct ShownMachine {
  std::string program;
  std::vector<ShownState> states;          ///< in the order of the text
  std::vector<ShownCondition> conditions;  ///< of the present state; the first that holds fires
};
/// A change of state, and why.
struct ShownChange {
  double ago_s = 0;
  std::string from_state, to_state;
  std::string cause;
  std::string place;                  ///< "office.bhdl:31", or empty
  std::vector<std::string> held_too;  ///< states to which a later condition would have led
  std::uint64_t missed = 0;           ///< changes before this one that were not heard
  bool filled = false;                ///< it fills a gap in which the robot could not be heard
};
struct ShownVariable {
  std::string name;
  std::string value;
  double certainty = 0;             ///< from 0 to 1; 0 if the variable is invalid
  std::vector<double> recent = {};  ///< what the curve shows, the oldest first; NaN: invalid
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
  std::vector<ShownRobot> robots;  ///< those in trouble first
  std::size_t known_robots = 0;    ///< also those that the filter hides
  std::size_t chosen = 0;
  ShownMachine machine;                  ///< the chosen robot's program
  std::vector<ShownChange> changes;      ///< of the chosen robot, the newest first
  std::vector<ShownVariable> variables;  ///< the chosen robot's variables
  std::size_t known_variables = 0;
  std::vector<PostedAlarm> alarms;  ///< those of the present
  Time now{};                       ///< the present, also where the rest is of the past
  bool is_past = false;
  std::optional<msg::Score> score;
  std::string map_title;
  std::vector<ShownObject> objects;
  std::vector<ShownPose> poses;
  std::shared_ptr<const Floor> floor;  ///< in the frame of the objects; nullptr: not known
};

/// What a snapshot is made of. `model` and `clock` are the present or the past.
struct Sources {
  const DashboardModel& model;
  const Clock& clock;
  const Identities& identities;
  Curves* curves = nullptr;           ///< none: variables have no curves
  const AlarmBoard* board = nullptr;  ///< none: there are no alarms
  const Clock* present = nullptr;     ///< where `clock` is of the past: that of the alarms
};
/// What somebody wants to see.
struct Choice {
  std::string robot;            ///< the chosen robot; if there is none of that name, the first
  std::string robot_filter;     ///< shows robots with this in their name, state or program
  std::string variable_filter;  ///< shows variables with this in their name
  std::string state = {};       ///< of the chosen robot's program; empty: none is chosen
};

/// Returns a snapshot. Robots that are silent come first, then those with alarms, each in the order
/// of their names. The chosen robot is shown whatever the filter. Without a monitor's map, only the
/// chosen robot is placed, in its own odom frame, because the robots' odom frames differ.
[[nodiscard]] View make_view(const Sources& sources, const Choice& choice);

}  // namespace galilean::monitor::top
