// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "core/result.h"
#include "monitor/team/team.h"

namespace galilean::monitor {

/// Returns the live team as the start of a simulation (`galilean sim --headless --start`): each
/// robot's pose in the map frame, state, variables and load, and the map's objects. Robots that are
/// silent or have no pose in the map are left out.
/// Errors: there is no map, or no robot is left.
[[nodiscard]] Result<nlohmann::json> situation_of(const Team& team,
                                                  const std::optional<msg::ObjectMap>& map);

}  // namespace galilean::monitor
