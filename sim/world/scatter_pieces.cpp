// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>

#include "sim/world/arena.h"
#include "sim/world/objects.h"

namespace galilean::sim {
namespace {

constexpr double kRobotReach_m = 0.35;
constexpr int kTries = 2000;

/// Returns the distance [m] from a point to the nearest point of a box, or 0 inside the box.
double distance_to(const Furniture& box, const Vec2& point_m) {
  const Vec2 local = rotated(point_m - box.pose.position_m, -box.pose.heading_rad);
  return (local.cwiseAbs() - box.size_m / 2).cwiseMax(0).norm();
}

bool free_of_furniture(const Scenario& scenario, const Vec2& at, double clearance_m) {
  return std::all_of(scenario.furniture.begin(), scenario.furniture.end(),
                     [&](const auto& box) { return distance_to(box, at) > clearance_m; }) &&
         std::all_of(scenario.chairs.begin(), scenario.chairs.end(), [&](const auto& chair) {
           const double reach_m = clearance_m + chair.pitch_m * 0.71;
           return (at - chair.pose.position_m).norm() > reach_m;
         });
}

bool is_free(const Scenario& scenario, const std::vector<PlacedPiece>& pieces, const Vec2& at) {
  const double clearance_m = scenario.clearance_m;
  const auto away = [&](double distance_m) {
    return [&, distance_m](const Vec2& other) { return (at - other).norm() > distance_m; };
  };
  const auto from_start = [&](const Pose2& start) {
    return (at - start.position_m).norm() > clearance_m + kRobotReach_m;
  };
  const auto from_piece = [&](const PlacedPiece& piece) {
    return away(clearance_m)(piece.position_m);
  };
  return free_of_furniture(scenario, at, clearance_m) &&
         std::all_of(scenario.baskets_m.begin(), scenario.baskets_m.end(),
                     away(clearance_m + scenario.rules.basket_zone_m)) &&
         std::all_of(scenario.starts.begin(), scenario.starts.end(), from_start) &&
         std::all_of(pieces.begin(), pieces.end(), from_piece);
}

}  // namespace

Result<std::vector<PlacedPiece>> scatter_pieces(const Scenario& scenario, Random random) {
  std::vector<PlacedPiece> pieces = scenario.placed;
  const double edge_m = scenario.clearance_m;
  for (int kind = 0; kind < kPieceKinds; ++kind)
    for (int i = 0; i < scenario.strewn[kind]; ++i) {
      Vec2 at;
      int tries = 0;
      do {
        if (++tries > kTries)
          return Error{scenario.name + ": pieces: no room for piece " +
                       std::to_string(pieces.size() + 1) +
                       "; expected fewer pieces or a smaller pieces.clearance_m"};
        at.x() = random.uniform(edge_m, scenario.arena.width_m - edge_m);
        at.y() = random.uniform(edge_m, scenario.arena.depth_m - edge_m);
      } while (!is_free(scenario, pieces, at));
      pieces.push_back({static_cast<PieceKind>(kind), at});
    }
  return pieces;
}

}  // namespace galilean::sim
