// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/top/gains/reach.h"

#include <algorithm>

namespace galilean::monitor::top {
namespace {

std::vector<const Robot*> reached(const Team& team, const std::string& name) {
  std::vector<const Robot*> robots;
  for (const auto& [each, robot] : team.robots()) {
    const bool serves =
        robot.state && !robot.state->out_of_service && !team.silent(robot) && !team.replayed(robot);
    if (name.empty() ? serves : each == name) robots.push_back(&robot);
  }
  return robots;
}

/// Returns whether they all say that they run this program.
bool all_run(const std::vector<const Robot*>& robots, const msg::Program& program) {
  return std::ranges::all_of(robots, [&](const Robot* robot) {
    return robot->state && robot->state->program_hash == program.hash;
  });
}

}  // namespace

Reach reach_of(const Team& team, const std::string& robot) {
  const auto robots = reached(team, robot);
  Reach reach;
  for (const Robot* each : robots) reach.robots.push_back(each->name);
  if (!robot.empty() || robots.size() < team.robots().size()) reach.targets = reach.robots;
  if (robots.empty()) return reach;
  const Robot& first = *robots.front();
  if (first.program && all_run(robots, *first.program)) reach.program = &*first.program;
  if (first.catalog) reach.catalog = &*first.catalog;
  return reach;
}

}  // namespace galilean::monitor::top
