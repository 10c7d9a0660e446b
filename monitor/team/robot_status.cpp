// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <string>

#include "core/wire/messages.h"
#include "core/wire/ros_time.h"
#include "monitor/team/break_reason.h"
#include "monitor/team/team.h"

namespace galilean::monitor {
namespace {

/// Returns the difference of two stamps of one robot. It needs no common clock, because both stamps
/// are of the robot's clock.
double seconds_between(const msg::Time& from, const msg::Time& to) {
  return static_cast<double>(wire::since_epoch_ns(to) - wire::since_epoch_ns(from)) * 1e-9;
}

void tell_state(const msg::RobotState& state, RobotStatus& status) {
  status.has_state = true;
  status.state = state.state;
  status.program_name = state.program_name;
  status.program_hash = state.program_hash;
  status.held = state.held;
  status.out_of_service = state.out_of_service;
  status.in_probation = state.in_probation;
  status.tick = state.tick;
  status.tick_time_us = state.tick_time_us;
  status.tick_time_max_us = state.tick_time_max_us;
  status.tick_period_s = state.tick_period_s;
  status.overruns = state.overruns;
  status.x_m = state.x_m;
  status.y_m = state.y_m;
  status.heading_rad = state.heading_rad;
  status.problems = state.problems;
}

}  // namespace

double certainty_after(const msg::Variable& variable, Duration age) noexcept {
  if (!variable.valid) return 0;
  return std::max(0.0, variable.certainty - variable.decay_per_s * to_seconds(age));
}

std::string_view to_string(Health health) noexcept {
  switch (health) {
    case Health::kWell:
      return "well";
    case Health::kTroubled:
      return "troubled";
    case Health::kSilent:
      return "silent";
  }
  return "";
}

RobotStatus Team::status(const Robot& robot) const {
  return status(robot, program_hash());
}

RobotStatus Team::status(const Robot& robot, const std::string& team_hash) const {
  RobotStatus status{.name = robot.name, .replayed = replayed(robot), .age_s = age_s(robot)};
  if (robot.state) {
    tell_state(*robot.state, status);
    status.in_state_s = seconds_between(robot.state->state_since, robot.state->stamp) +
                        to_seconds(clock_.now() - robot.state_received);
    status.drifting =
        !status.out_of_service && !status.replayed && status.program_hash != team_hash;
  }
  if (robot.clock_ahead_s > kClockAhead_s) {
    status.clock_ahead_s = robot.clock_ahead_s;
    status.problems.push_back("its clock is " + std::to_string(std::llround(robot.clock_ahead_s)) +
                              " s ahead of this machine's; set the clock of one of them");
  }
  if (!silent(robot)) status.break_reason = break_reason(robot, since_breaks(robot));
  for (const auto& variable : robot.variables.items) {
    if (!variable.valid) continue;
    const double certainty = certainty_now(robot, variable);
    if (!status.least_certain.empty() && certainty >= status.lowest_certainty) continue;
    status.lowest_certainty = certainty;
    status.least_certain = variable.name;
  }
  const bool tick_late = status.tick_time_max_us > status.tick_period_s * 1e6;
  status.health = silent(robot)                           ? Health::kSilent
                  : !status.problems.empty() || tick_late ? Health::kTroubled
                                                          : Health::kWell;
  return status;
}

}  // namespace galilean::monitor
