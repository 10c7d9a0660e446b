// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "core/result.h"
#include "robot/executive/restore.h"
#include "sim/scenario/scenario.h"

namespace galilean::sim {

/// One robot of a team that was copied into the simulator.
struct RobotSituation {
  std::string name;
  Pose2 pose;  ///< map frame
  bool holds_piece = false;
  robot::Situation program;
};

/// A live team as it knows itself, in the map frame. A contest can go on from it.
struct TeamSituation {
  std::vector<RobotSituation> robots;  ///< the simulator's robots take these in order
  std::vector<Vec2> pieces_m;          ///< trash that the map has
  std::vector<Vec2> baskets_m;
  int unseen_pieces = 0;  ///< pieces that nobody has seen; the seed strews them
};

/// Reads a situation from a JSON file. Errors: one line with file, JSON path and what is expected.
[[nodiscard]] Result<TeamSituation> load_situation(const std::string& path);
[[nodiscard]] Result<TeamSituation> situation_from_json(const std::string& text,
                                                        const std::string& file_name);

/// Returns the scenario's arena, furniture and rules with the situation's robots, pieces and
/// baskets. A basket of the scenario that the map has not found stays where the scenario says.
[[nodiscard]] Scenario scenario_of(const Scenario& arena, const TeamSituation& situation);

}  // namespace galilean::sim
