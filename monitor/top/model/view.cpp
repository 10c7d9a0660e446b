// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/top/model/view.h"

#include <algorithm>
#include <cctype>
#include <cmath>

#include "core/wire/messages.h"
#include "monitor/top/model/variable_text.h"

namespace galilean::monitor::top {
namespace {

void show_robots(const Team& team, View& view) {
  for (auto& status : team.statuses()) {
    const char letter = letter_for(status.name, view.robots);
    view.robots.push_back({letter, std::move(status)});
  }
}

void show_program(const Robot& robot, View& view) {
  const std::string current = robot.state ? robot.state->state : "";
  if (robot.program)
    for (const auto& state : robot.program->states)
      view.states.push_back({state.name, state.name == current});
  else if (!current.empty())
    view.states.push_back({current, true});
}

void show_variables(const Team& team, const Robot& robot, View& view) {
  for (const auto& variable : robot.variables.items)
    view.variables.push_back(
        {variable.name, variable_text(variable), team.certainty_now(robot, variable)});
}

void show_team_map(const msg::ObjectMap& map, double age_s, View& view) {
  view.map_title = "the team's map";
  for (const auto& object : map.objects) {
    const double certainty = std::max(0.0, object.certainty - object.decay_per_s * age_s);
    view.objects.push_back({object.object_class, {object.x_m, object.y_m}, certainty});
  }
  for (const auto& robot : map.robots)
    for (std::size_t i = 0; i < view.robots.size(); ++i)
      if (view.robots[i].status.name == robot.name)
        view.poses.push_back({i, {{robot.x_m, robot.y_m}, robot.heading_rad}});
}

void show_own_map(const DashboardModel& model, View& view) {
  const RobotStatus& status = view.robots[view.chosen].status;
  view.map_title = status.name + "'s own frame (no monitor)";
  view.poses.push_back({view.chosen, {{status.x_m, status.y_m}, status.heading_rad}});
  if (const auto* seen = model.sightings(status.name))
    for (const auto& sighting : seen->items)
      view.objects.push_back({sighting.object_class, {sighting.x_m, sighting.y_m}, 1});
}

}  // namespace

char letter_for(const std::string& name, const std::vector<ShownRobot>& others) {
  const auto taken = [&](char letter) {
    return std::any_of(others.begin(), others.end(),
                       [&](const ShownRobot& other) { return other.letter == letter; });
  };
  const std::string spare = "ABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789";
  for (const char c : name + spare) {
    const auto letter = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
    if (spare.find(letter) != std::string::npos && !taken(letter)) return letter;
  }
  return '?';
}

View make_view(const DashboardModel& model, const Clock& clock, const std::string& chosen) {
  View view;
  show_robots(model.team(), view);
  view.score = model.team().score();
  if (view.robots.empty()) return view;
  for (std::size_t i = 0; i < view.robots.size(); ++i)
    if (view.robots[i].status.name == chosen) view.chosen = i;
  const Robot& robot = *model.team().find(view.robots[view.chosen].status.name);
  show_program(robot, view);
  show_variables(model.team(), robot, view);
  if (const auto* map = model.objects()) {
    show_team_map(*map, to_seconds(clock.now() - model.objects_received()), view);
    if (const auto* floor = model.floor()) view.floor = *floor;
  } else {
    show_own_map(model, view);
  }
  return view;
}

}  // namespace galilean::monitor::top
