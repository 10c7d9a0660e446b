// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <nlohmann/json.hpp>

#include "monitor/team/team.h"

namespace galilean::monitor {

/// The members of RobotStatus, by their names.
[[nodiscard]] nlohmann::json to_json(const RobotStatus& status);
/// The referee's sheet, null while there is none.
[[nodiscard]] nlohmann::json score_json(const Team& team);
/// How each program fared in the contest.
[[nodiscard]] nlohmann::json strategies_json(const Team& team);
/// All that is known of the team: each robot's status, variables with their certainty now, and its
/// last transitions; the score; the hash of the team's program.
[[nodiscard]] nlohmann::json to_json(const Team& team);

}  // namespace galilean::monitor
