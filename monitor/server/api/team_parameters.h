// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "monitor/lease/lease_desk.h"
#include "monitor/server/api/operations.h"
#include "monitor/server/foxglove/foxglove_hub.h"

namespace galilean::monitor {

/// Returns the team as Foxglove's parameters: each robot's /NAME.held, which clients can set, the
/// name and hash of each robot's program, the hash of the team's program, the names of the
/// robots that a recording plays, the changes of state that fill a gap, and the leases that
/// somebody holds.
[[nodiscard]] foxglove::ParameterValues team_parameters(const Team& team, const LeaseDesk& leases);

/// Holds or resumes a robot whose /NAME.held `who` sets.
/// Errors: `wanted` is another parameter or no boolean, or the command fails.
void set_team_parameter(Operations& operations, const foxglove::Parameter& wanted,
                        const OperatorId& who, foxglove::Hub::Answer answer);

}  // namespace galilean::monitor
