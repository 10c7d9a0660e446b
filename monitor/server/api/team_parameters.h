// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "monitor/server/api/operations.h"
#include "monitor/server/foxglove/foxglove_hub.h"

namespace galilean::monitor {

/// Returns the team as Foxglove's parameters: each robot's /NAME.held, which clients can set, the
/// name and hash of each robot's program, the hash of the team's program, and the names of the
/// robots that a recording plays.
[[nodiscard]] foxglove::ParameterValues team_parameters(const Team& team);

/// Holds or resumes a robot whose /NAME.held is set.
/// Errors: `wanted` is another parameter or no boolean, or the command fails.
void set_team_parameter(Operations& operations, const foxglove::Parameter& wanted,
                        foxglove::Hub::Answer answer);

}  // namespace galilean::monitor
