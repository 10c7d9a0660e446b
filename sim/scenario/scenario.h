// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "core/geometry.h"
#include "core/result.h"

namespace galilean::sim {

enum class PieceKind { kCan, kCup, kWad };
inline constexpr int kPieceKinds = 3;
[[nodiscard]] const char* to_string(PieceKind kind) noexcept;

/// The arena is a rectangle from (0, 0) to (width, depth) with a wall around it.
struct ArenaRules {
  double width_m = 8;
  double depth_m = 6;
  double wall_height_m = 1.2;
};

enum class FurnitureKind { kTable, kDesk, kScreen };

/// A box on the floor: a table with a floor-length blue skirt, a desk, or a screen (an inner wall).
struct Furniture {
  FurnitureKind kind = FurnitureKind::kTable;
  Pose2 pose;
  Vec2 size_m = {1.8, 0.75};  ///< along and across its heading
  double height_m = 0.74;
};

/// Four legs and a seat. A robot can push it, but a gripper cannot hold it.
struct Chair {
  Pose2 pose;
  double pitch_m = 0.36;  ///< from leg to leg
  double seat_height_m = 0.45;
};

/// A ceiling light or a bright window: where the floor mirrors it, the camera is dazzled.
struct Light {
  Vec2 position_m = Vec2::Zero();
  double height_m = 2.4;
  double radius_m = 0.6;
};

/// A piece of trash that lies where the scenario says; all others are strewn by the seed.
struct PlacedPiece {
  PieceKind kind = PieceKind::kCan;
  Vec2 position_m = Vec2::Zero();
};

struct Rules {
  double duration_s = 600;
  double points_per_piece = 10;
  double penalty_per_collision = 1;
  double collision_speed_mps = 0.12;  ///< a touch that takes away at least this much speed counts
  double collision_pause_s = 3;       ///< a pair's touch counts only after this time without one
  double basket_zone_m = 0.6;  ///< from the basket's centre; a piece that is released there is
                               ///< thrown away
};

/// How far the treads are from ideal. Each robot draws its own values from the seed.
struct Slip {
  double scale_error = 0.012;     ///< standard deviation of both treads' true length
  double mismatch = 0.002;        ///< standard deviation of one tread's length against the other's
  double turn_error = 0.01;       ///< standard deviation of the true turning radius
  double straight_noise = 0.015;  ///< share of the speed that is lost and won at random
  double turning_noise = 0.03;    ///< the same, while the treads scrub
};

struct CameraRules {
  double noise_levels = 5;  ///< standard deviation of a pixel's 0 … 255
  double rate_hz = 10;
};

/// All that a contest is made of, in SI and in the arena's frame ("map").
struct Scenario {
  std::string name;
  ArenaRules arena;
  std::vector<Furniture> furniture;
  std::vector<Chair> chairs;
  std::vector<Vec2> baskets_m;
  std::vector<PlacedPiece> placed;
  int strewn[kPieceKinds] = {0, 0, 0};  ///< pieces of each kind that the seed strews
  double clearance_m = 0.4;             ///< between a strewn piece and anything else
  std::vector<Pose2> starts;            ///< robots stand here, in the order of their names
  double start_jitter_m = 0.1;
  double start_jitter_rad = 0.2;
  std::vector<Light> lights;
  Rules rules;
  Slip slip;
  CameraRules camera;
};

/// Loads a scenario. `name_or_path` is the name of one that ships ("office"), or a file
/// ("./mine.json"). Errors: one line with file, JSON path and what is expected.
[[nodiscard]] Result<Scenario> load_scenario(const std::string& name_or_path);
[[nodiscard]] Result<Scenario> scenario_from_json(const std::string& text,
                                                  const std::string& file_name);
/// Returns the names of the scenarios that ship, sorted.
[[nodiscard]] std::vector<std::string> shipped_scenarios();

}  // namespace galilean::sim
