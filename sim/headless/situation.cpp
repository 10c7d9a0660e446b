// SPDX-License-Identifier: BSD-3-Clause
#include "sim/headless/situation.h"

#include <algorithm>

#include "core/json_text.h"
#include "core/regular_file.h"
#include "sim/scenario/json_reader.h"
#include "sim/world/gripper.h"

namespace galilean::sim {
namespace {

constexpr double kFarthest_m = 1000;
constexpr int kMostPieces = 500;
constexpr std::uintmax_t kMostBytes = std::uintmax_t{1} << 20;

Vec2 read_place(JsonReader& item) {
  return {item.number("x_m", -kFarthest_m, kFarthest_m),
          item.number("y_m", -kFarthest_m, kFarthest_m)};
}

robot::VariableSituation read_variable(JsonReader& item) {
  robot::VariableSituation variable;
  variable.name = item.text("name");
  variable.type = item.text("type");
  if (item.has("object_class")) variable.object_class = item.text("object_class");
  variable.valid = item.flag("valid");
  variable.certainty = item.number("certainty", 0, 1);
  variable.values = item.numbers("values");
  item.finish();
  return variable;
}

RobotSituation read_robot(JsonReader& item) {
  RobotSituation robot;
  robot.name = item.text("name");
  robot.pose = {read_place(item), item.number("heading_rad", -1e6, 1e6)};
  robot.holds_piece = item.has("holds") && item.text("holds") == "trash";
  robot.program.state = item.text("state");
  for (auto& variable : item.list("variables"))
    robot.program.variables.push_back(read_variable(variable));
  item.finish();
  return robot;
}

void read_object(JsonReader& item, TeamSituation& situation) {
  const auto object_class = item.text("class");
  const Vec2 place_m = read_place(item);
  item.finish();
  if (object_class == "trash") situation.pieces_m.push_back(place_m);
  if (object_class == "basket") situation.baskets_m.push_back(place_m);
}

TeamSituation read_situation(const nlohmann::json& document) {
  TeamSituation situation;
  JsonReader root(document, "");
  for (auto& robot : root.list("robots")) situation.robots.push_back(read_robot(robot));
  if (situation.robots.empty())
    throw JsonError(root.path_of("robots") + ": expected at least one robot");
  for (auto& object : root.list("objects")) read_object(object, situation);
  situation.unseen_pieces = root.integer_or("unseen_pieces", 0, 0, kMostPieces);
  root.finish();
  return situation;
}

Vec2 pocket_of(const Pose2& robot) {
  return robot.position_m + rotated({Gripper::kPocket_m, 0}, robot.heading_rad);
}

/// Odometry drifts through walls, but bodies cannot stand there. Returns the nearest place inside.
Vec2 inside(const ArenaRules& arena, const Vec2& at_m, double margin_m) {
  return {std::clamp(at_m.x(), margin_m, arena.width_m - margin_m),
          std::clamp(at_m.y(), margin_m, arena.depth_m - margin_m)};
}

}  // namespace

Result<TeamSituation> situation_from_json(const std::string& text, const std::string& file_name) {
  const auto json = read_json(text);
  if (!json) return Error{file_name + ": " + json.error().message};
  try {
    return read_situation(json.value());
  } catch (const JsonError& error) {
    return Error{file_name + ": " + error.what()};
  }
}

Result<TeamSituation> load_situation(const std::string& path) {
  const auto text = read_regular_file(path, kMostBytes);
  if (!text) return Error{path + ": cannot be read: " + text.error().message};
  return situation_from_json(text.value(), path);
}

Scenario scenario_of(const Scenario& arena, const TeamSituation& situation) {
  constexpr double kRobotMargin_m = 0.3, kPieceMargin_m = 0.06, kBasketMargin_m = 0.15;
  constexpr double kSameBasket_m = 1;
  Scenario scenario = arena;
  scenario.start_jitter_m = scenario.start_jitter_rad = 0;
  scenario.starts.clear();
  scenario.placed.clear();
  for (const auto& at : situation.pieces_m)
    scenario.placed.push_back({PieceKind::kCan, inside(arena.arena, at, kPieceMargin_m)});
  for (const auto& robot : situation.robots) {
    scenario.starts.push_back(
        {inside(arena.arena, robot.pose.position_m, kRobotMargin_m), robot.pose.heading_rad});
    if (robot.holds_piece)
      scenario.placed.push_back({PieceKind::kCan, pocket_of(scenario.starts.back())});
  }
  std::fill(std::begin(scenario.strewn), std::end(scenario.strewn), 0);
  scenario.strewn[static_cast<int>(PieceKind::kCan)] = situation.unseen_pieces;
  scenario.baskets_m.clear();
  for (const auto& at : situation.baskets_m)
    scenario.baskets_m.push_back(inside(arena.arena, at, kBasketMargin_m));
  for (const auto& at : arena.baskets_m)
    if (std::ranges::none_of(situation.baskets_m, [&](const Vec2& known) {
          return (known - at).norm() < kSameBasket_m;
        }))
      scenario.baskets_m.push_back(at);
  return scenario;
}

}  // namespace galilean::sim
