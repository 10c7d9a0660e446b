// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <string>
#include <vector>

#include "core/wire/endpoints.h"
#include "monitor/replay/tracks.h"

namespace galilean::monitor {

/// Names of robots, and of the referee and the simulation, sorted.
struct Neighbours {
  std::vector<std::string> live;
  std::vector<std::string> played;  ///< by a replay

  [[nodiscard]] bool empty() const noexcept { return live.empty() && played.empty(); }
};

/// Returns those that write the recording's topics in the domain. A replay would mix its messages
/// with theirs.
/// Those of a Stage of this process count as played.
[[nodiscard]] Neighbours namesakes(const std::vector<wire::EndpointInfo>& endpoints,
                                   const std::map<std::uint16_t, Track>& tracks);

/// Returns the robots in the domain, whatever their names: those that tell their state.
/// Those of a Stage of this process count as played.
[[nodiscard]] Neighbours robots_in(const std::vector<wire::EndpointInfo>& endpoints);

}  // namespace galilean::monitor
