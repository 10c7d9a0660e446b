// SPDX-License-Identifier: BSD-3-Clause
#include "sim/scenario/scenario.h"

#include <algorithm>
#include <array>

#include "core/json_text.h"
#include "core/visible_text.h"
#include "sim/scenario/json_reader.h"

namespace galilean::sim {
namespace {

constexpr double kDegree = kPi / 180;
constexpr double kLargestArena_m = 60;
constexpr std::array<const char*, kPieceKinds> kPieceNames{"can", "cup", "wad"};

Pose2 read_pose(JsonReader& item) {
  return {item.pair("at"), item.number_or("heading_deg", 0, -360, 360) * kDegree};
}

void read_arena(JsonReader item, ArenaRules& arena) {
  arena.width_m = item.number("width_m", 1, kLargestArena_m);
  arena.depth_m = item.number("depth_m", 1, kLargestArena_m);
  arena.wall_height_m = item.number_or("wall_height_m", arena.wall_height_m, 0.3, 10);
  item.finish();
}

void read_furniture(std::vector<JsonReader> items, FurnitureKind kind, const Vec2& size_m,
                    double height_m, std::vector<Furniture>& out) {
  for (auto& item : items) {
    Furniture box{kind, read_pose(item), item.pair_or("size_m", size_m),
                  item.number_or("height_m", height_m, 0.3, 10)};
    if (box.size_m.minCoeff() < 0.04)
      throw JsonError(item.path_of("size_m") + ": expected two lengths of at least 0.04 m");
    item.finish();
    out.push_back(box);
  }
}

void read_chairs(std::vector<JsonReader> items, std::vector<Chair>& chairs) {
  for (auto& item : items) {
    Chair chair;
    chair.pose = read_pose(item);
    chair.pitch_m = item.number_or("pitch_m", chair.pitch_m, 0.1, 1);
    chair.seat_height_m = item.number_or("seat_height_m", chair.seat_height_m, 0.35, 1);
    item.finish();
    chairs.push_back(chair);
  }
}

PieceKind read_kind(JsonReader& item) {
  const std::string word = item.text("kind");
  const auto found = std::find(kPieceNames.begin(), kPieceNames.end(), word);
  if (found == kPieceNames.end())
    throw JsonError(item.path_of("kind") + ": expected can, cup or wad, found \"" + visible(word) +
                    "\"");
  return static_cast<PieceKind>(found - kPieceNames.begin());
}

void read_pieces(JsonReader item, Scenario& scenario) {
  constexpr int kMost = 500;
  scenario.strewn[0] = item.integer_or("cans", 0, 0, kMost);
  scenario.strewn[1] = item.integer_or("cups", 0, 0, kMost);
  scenario.strewn[2] = item.integer_or("wads", 0, 0, kMost);
  scenario.clearance_m = item.number_or("clearance_m", scenario.clearance_m, 0.05, 3);
  for (auto& placed : item.list("placed")) {
    scenario.placed.push_back({read_kind(placed), placed.pair("at")});
    placed.finish();
  }
  item.finish();
}

void read_robots(JsonReader item, Scenario& scenario) {
  scenario.start_jitter_m = item.number_or("jitter_m", scenario.start_jitter_m, 0, 1);
  scenario.start_jitter_rad =
      item.number_or("jitter_deg", scenario.start_jitter_rad / kDegree, 0, 180) * kDegree;
  for (auto& start : item.list("starts")) {
    scenario.starts.push_back(read_pose(start));
    start.finish();
  }
  if (scenario.starts.empty())
    throw JsonError(item.path_of("starts") + ": expected at least one place for a robot");
  item.finish();
}

void read_lights(std::vector<JsonReader> items, std::vector<Light>& lights) {
  for (auto& item : items) {
    Light light;
    light.position_m = item.pair("at");
    light.height_m = item.number_or("height_m", light.height_m, 0.5, 20);
    light.radius_m = item.number_or("radius_m", light.radius_m, 0.05, 5);
    item.finish();
    lights.push_back(light);
  }
}

void read_rules(JsonReader item, Rules& rules) {
  rules.duration_s = item.number_or("duration_s", rules.duration_s, 1, 86400);
  rules.points_per_piece = item.number_or("points_per_piece", rules.points_per_piece, 0, 1e6);
  rules.penalty_per_collision =
      item.number_or("penalty_per_collision", rules.penalty_per_collision, 0, 1e6);
  rules.collision_speed_mps =
      item.number_or("collision_speed_mps", rules.collision_speed_mps, 0, 10);
  rules.collision_pause_s = item.number_or("collision_pause_s", rules.collision_pause_s, 0, 600);
  rules.basket_zone_m = item.number_or("basket_zone_m", rules.basket_zone_m, 0.05, 5);
  item.finish();
}

void read_slip(JsonReader item, Slip& slip) {
  slip.scale_error = item.number_or("scale_error", slip.scale_error, 0, 0.2);
  slip.mismatch = item.number_or("mismatch", slip.mismatch, 0, 0.2);
  slip.turn_error = item.number_or("turn_error", slip.turn_error, 0, 0.2);
  slip.straight_noise = item.number_or("straight_noise", slip.straight_noise, 0, 0.5);
  slip.turning_noise = item.number_or("turning_noise", slip.turning_noise, 0, 0.5);
  item.finish();
}

void read_camera(JsonReader item, CameraRules& camera) {
  camera.noise_levels = item.number_or("noise_levels", camera.noise_levels, 0, 40);
  camera.rate_hz = item.number_or("rate_hz", camera.rate_hz, 1, 60);
  item.finish();
}

void require_inside(const ArenaRules& arena, const Vec2& at, const std::string& what) {
  if (at.x() < 0 || at.y() < 0 || at.x() > arena.width_m || at.y() > arena.depth_m)
    throw JsonError(what + ": stands outside the arena");
}

void check_places(const Scenario& scenario) {
  const auto number = [](const char* list, std::size_t i) {
    return std::string(list) + "[" + std::to_string(i) + "].at";
  };
  for (std::size_t i = 0; i < scenario.starts.size(); ++i)
    require_inside(scenario.arena, scenario.starts[i].position_m, number("robots.starts", i));
  for (std::size_t i = 0; i < scenario.baskets_m.size(); ++i)
    require_inside(scenario.arena, scenario.baskets_m[i], number("baskets", i));
  for (std::size_t i = 0; i < scenario.placed.size(); ++i)
    require_inside(scenario.arena, scenario.placed[i].position_m, number("pieces.placed", i));
}

Scenario read_scenario(const nlohmann::json& document) {
  Scenario scenario;
  JsonReader root(document, "");
  scenario.name = root.text("name");
  read_arena(root.object("arena"), scenario.arena);
  auto& furniture = scenario.furniture;
  read_furniture(root.list("tables"), FurnitureKind::kTable, {1.8, 0.75}, 0.74, furniture);
  read_furniture(root.list("desks"), FurnitureKind::kDesk, {1.4, 0.7}, 0.72, furniture);
  read_furniture(root.list("screens"), FurnitureKind::kScreen, {1.5, 0.06},
                 scenario.arena.wall_height_m, furniture);
  read_chairs(root.list("chairs"), scenario.chairs);
  for (auto& basket : root.list("baskets")) {
    scenario.baskets_m.push_back(basket.pair("at"));
    basket.finish();
  }
  read_pieces(root.object("pieces"), scenario);
  read_robots(root.object("robots"), scenario);
  read_lights(root.list("lights"), scenario.lights);
  read_rules(root.object("rules"), scenario.rules);
  read_slip(root.object("slip"), scenario.slip);
  read_camera(root.object("camera"), scenario.camera);
  root.finish();
  check_places(scenario);
  return scenario;
}

}  // namespace

const char* to_string(PieceKind kind) noexcept {
  return kPieceNames[static_cast<std::size_t>(kind)];
}

Result<Scenario> scenario_from_json(const std::string& text, const std::string& file_name) {
  const auto json = read_json(text);
  if (!json)
    return Error{file_name + ": " + json.error().message +
                 "; expected a scenario like sim/scenarios/office.json"};
  try {
    return read_scenario(json.value());
  } catch (const JsonError& error) {
    return Error{file_name + ": " + error.what()};
  }
}

}  // namespace galilean::sim
