// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/trial/situation.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/catalog/wiring.h"
#include "core/variable/type_name.h"

namespace galilean::monitor {
namespace {

using nlohmann::json;

std::string type_name(std::uint8_t type) {
  namespace types = msg::Variable_Constants;
  switch (type) {
    case types::SHAFT:
      return variable_type_name<Shaft>();
    case types::IMAGE:
      return variable_type_name<Image>();
    case types::LOCATE:
      return variable_type_name<Locate>();
    case types::BITS:
      return variable_type_name<Bits>();
    default:
      return variable_type_name<Force>();
  }
}

/// Returns nothing if a value is not finite, because JSON has no such number.
std::optional<json> to_json(const Team& team, const Robot& robot, const msg::Variable& variable) {
  if (!std::ranges::all_of(variable.values, [](double value) { return std::isfinite(value); }))
    return std::nullopt;
  const double certainty = team.certainty_now(robot, variable);
  return json{{"name", variable.name},
              {"type", type_name(variable.type)},
              {"object_class", variable.object_class},
              {"valid", variable.valid},
              {"certainty", std::clamp(std::isfinite(certainty) ? certainty : 0, 0.0, 1.0)},
              {"values", variable.values}};
}

json to_json(const Team& team, const Robot& robot, const msg::MapRobot& placed,
             const msg::ObjectMap& map) {
  auto variables = json::array();
  for (const auto& variable : robot.variables.items)
    if (auto one = to_json(team, robot, variable)) variables.push_back(std::move(*one));
  json result{{"name", robot.name},          {"x_m", placed.x_m},
              {"y_m", placed.y_m},           {"heading_rad", placed.heading_rad},
              {"state", robot.state->state}, {"variables", std::move(variables)}};
  const auto load = std::ranges::find(map.objects, robot.name, &msg::MapObject::held_by);
  if (load != map.objects.end()) result["holds"] = load->object_class;
  return result;
}

json objects_json(const msg::ObjectMap& map) {
  auto objects = json::array();
  for (const auto& object : map.objects)
    if (object.held_by.empty())
      objects.push_back({{"class", object.object_class}, {"x_m", object.x_m}, {"y_m", object.y_m}});
  return objects;
}

/// Returns how many pieces of trash the referee still counts but the map does not have.
int unseen_pieces(const Team& team, const msg::ObjectMap& map) {
  if (!team.score()) return 0;
  const auto left = static_cast<std::ptrdiff_t>(team.score()->pieces) - team.score()->deposited;
  const auto known = std::ranges::count(map.objects, "trash", &msg::MapObject::object_class);
  return static_cast<int>(std::max<std::ptrdiff_t>(left - known, 0));
}

}  // namespace

Result<json> situation_of(const Team& team, const std::optional<msg::ObjectMap>& map) {
  if (!map) return Error{"the team has no map yet, so the robots' poses are not known"};
  auto robots = json::array();
  for (const auto& [name, robot] : team.robots()) {
    const auto placed = std::ranges::find(map->robots, name, &msg::MapRobot::name);
    if (!robot.state || team.silent(robot) || placed == map->robots.end()) continue;
    robots.push_back(to_json(team, robot, *placed, *map));
  }
  if (robots.empty()) return Error{"no robot that is heard has a pose on the map"};
  return json{{"robots", std::move(robots)},
              {"objects", objects_json(*map)},
              {"unseen_pieces", unseen_pieces(team, *map)}};
}

}  // namespace galilean::monitor
