// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "core/result.h"
#include "monitor/team/team.h"

namespace galilean::monitor {

/// The live team as `galilean sim --headless --start` takes it: poses in the map's frame, states,
/// variables, what each holds, and the objects that the map has. Robots that are silent, or that
/// the map does not place, are left out; the error says that none is left.
[[nodiscard]] Result<nlohmann::json> situation_of(const Team& team,
                                                  const std::optional<msg::ObjectMap>& map);

}  // namespace galilean::monitor
