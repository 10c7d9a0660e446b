// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <nlohmann/json.hpp>

#include "monitor/team/team.h"

namespace galilean::monitor {

/// Returns the members of RobotStatus by their names.
[[nodiscard]] nlohmann::json to_json(const RobotStatus& status);
/// Returns the referee's score, or null before the first one came.
[[nodiscard]] nlohmann::json score_json(const Team& team);
/// Returns a list with the score of each program in the contest.
[[nodiscard]] nlohmann::json strategies_json(const Team& team);
/// Returns each robot's status, its variables with their present certainty, its last transitions
/// and its break points, the score, and the hash of the team's program.
[[nodiscard]] nlohmann::json to_json(const Team& team);

}  // namespace galilean::monitor
