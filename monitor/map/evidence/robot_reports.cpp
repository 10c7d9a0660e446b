// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/map/evidence/robot_reports.h"

#include <cmath>
#include <utility>

namespace galilean::monitor {
namespace {

/// Numbers that are not finite fail the comparisons.
bool is_plausible_place(const msg::Variable& place) {
  constexpr double kFarthest_m = 1e6;
  return std::abs(place.values[0]) <= kFarthest_m && std::abs(place.values[1]) <= kFarthest_m &&
         place.certainty >= 0;
}

bool is_obstacle(const msg::Variable& variable) {
  return variable.type == msg::Variable_Constants::LOCATE && variable.valid &&
         variable.object_class == "obstacle" && variable.values.size() >= 2 &&
         is_plausible_place(variable);
}

}  // namespace

void RobotReports::add(const msg::Variables& variables, Time now) {
  Robot& robot = robots_[variables.robot];
  robot.heard = now;
  robot.sensors.update(variables, now);
}

std::vector<msg::Variable> RobotReports::take_new_obstacles(const msg::Variables& variables) {
  Robot& robot = robots_[variables.robot];
  std::vector<msg::Variable> written;
  for (const auto& variable : variables.items) {
    if (!is_obstacle(variable)) continue;
    const auto [touched, is_new] = robot.touched.try_emplace(variable.name, variable.updated);
    if (is_new || std::exchange(touched->second, variable.updated) != variable.updated)
      written.push_back(variable);
  }
  return written;
}

void RobotReports::add(const msg::Catalog& catalog, Time now) {
  Robot& robot = robots_[catalog.robot];
  robot.heard = now;
  if (auto read = catalog_from_json(catalog.json)) robot.catalog = std::move(read).value();
  if (robot.program) robot.sensors.set_program(*robot.program, robot.catalog);
}

void RobotReports::add(const msg::Program& program, Time now) {
  Robot& robot = robots_[program.robot];
  robot.heard = now;
  robot.program = program;
  robot.sensors.set_program(program, robot.catalog);
}

}  // namespace galilean::monitor
