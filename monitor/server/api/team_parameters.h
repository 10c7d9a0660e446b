// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "monitor/server/api/operations.h"
#include "monitor/server/foxglove/foxglove_hub.h"

namespace galilean::monitor {

/// The team as Foxglove's parameters: /NAME.held, which can be set, and what each runs.
[[nodiscard]] foxglove::ParameterValues team_parameters(const Team& team);

/// Holds or resumes a robot whose /NAME.held is set; the others are refused.
void set_team_parameter(Operations& operations, const foxglove::Parameter& wanted,
                        foxglove::Hub::Answer answer);

}  // namespace galilean::monitor
