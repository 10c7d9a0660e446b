// SPDX-License-Identifier: BSD-3-Clause
#include "sim/scenario/enlarge.h"

#include <algorithm>
#include <cmath>

namespace galilean::sim {
namespace {

/// How often the scenario is laid beside itself, along x and along y.
struct Copies {
  std::size_t columns = 1, rows = 1;
};

std::size_t divided_up(std::size_t number, std::size_t by) {
  return (number + by - 1) / by;
}

/// Returns copies with enough places, in an arena that is about as wide as it is deep.
Copies copies_for(const Scenario& scenario, std::size_t robots) {
  const std::size_t needed = divided_up(robots, scenario.starts.size());
  const double columns =
      std::sqrt(static_cast<double>(needed) * scenario.arena.depth_m / scenario.arena.width_m);
  Copies copies{.columns =
                    std::max<std::size_t>(1, static_cast<std::size_t>(std::lround(columns)))};
  copies.columns = std::min(copies.columns, needed);
  copies.rows = divided_up(needed, copies.columns);
  return copies;
}

Pose2 moved(const Pose2& pose, const Vec2& by_m) {
  return {pose.position_m + by_m, pose.heading_rad};
}

bool is_inside(const ArenaRules& arena, const Vec2& at_m) {
  return at_m.minCoeff() >= 0 && at_m.x() <= arena.width_m && at_m.y() <= arena.depth_m;
}

void add_copy(const Scenario& scenario, const Vec2& by_m, Scenario& to) {
  for (const Furniture& box : scenario.furniture) {
    to.furniture.push_back(box);
    to.furniture.back().pose = moved(box.pose, by_m);
  }
  for (const Chair& chair : scenario.chairs) {
    to.chairs.push_back(chair);
    to.chairs.back().pose = moved(chair.pose, by_m);
  }
  for (const Vec2& at_m : scenario.baskets_m) to.baskets_m.push_back(at_m + by_m);
  for (const PlacedPiece& piece : scenario.placed)
    to.placed.push_back({piece.kind, piece.position_m + by_m});
  for (int kind = 0; kind < kPieceKinds; ++kind) to.strewn[kind] += scenario.strewn[kind];
  for (const Pose2& start : scenario.starts) to.starts.push_back(moved(start, by_m));
  for (const Light& light : scenario.lights)
    if (is_inside(scenario.arena, light.position_m)) {
      to.lights.push_back(light);
      to.lights.back().position_m += by_m;
    }
}

/// Moves lights behind the far walls, such as windows, with these walls.
void move_outer_lights(const ArenaRules& before, const ArenaRules& now,
                       std::vector<Light>& lights) {
  for (Light& light : lights) {
    if (is_inside(before, light.position_m)) continue;
    if (light.position_m.x() > before.width_m) light.position_m.x() += now.width_m - before.width_m;
    if (light.position_m.y() > before.depth_m) light.position_m.y() += now.depth_m - before.depth_m;
  }
}

}  // namespace

Scenario enlarged_for(const Scenario& scenario, std::size_t robots) {
  Scenario large = scenario;
  if (robots <= scenario.starts.size() || scenario.starts.empty()) return large;
  const Copies copies = copies_for(scenario, robots);
  large.arena.width_m *= static_cast<double>(copies.columns);
  large.arena.depth_m *= static_cast<double>(copies.rows);
  move_outer_lights(scenario.arena, large.arena, large.lights);
  for (std::size_t copy = 1; copy < copies.columns * copies.rows; ++copy) {
    const std::size_t column = copy % copies.columns, row = copy / copies.columns;
    add_copy(scenario,
             {static_cast<double>(column) * scenario.arena.width_m,
              static_cast<double>(row) * scenario.arena.depth_m},
             large);
  }
  return large;
}

}  // namespace galilean::sim
