// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "core/wire/endpoints.h"

namespace galilean::wire {

/// Names of robots, and of the referee and the simulation, sorted.
struct Neighbours {
  std::vector<std::string> live;
  std::vector<std::string> played;  ///< by a replay

  [[nodiscard]] bool empty() const noexcept { return live.empty() && played.empty(); }
};

/// Returns the name before a topic's second slash: "io" for "rt/io/state".
[[nodiscard]] std::string owner_of(const std::string& topic);
/// Returns the owners of the topics that are written and that `counts` accepts.
[[nodiscard]] Neighbours owners(const std::vector<EndpointInfo>& endpoints,
                                const std::function<bool(const EndpointInfo&)>& counts);
/// Returns the robots in the domain, whatever their names: those that tell their state.
/// Those of this process count as live, or as played if it is a replay.
[[nodiscard]] Neighbours robots_in(const std::vector<EndpointInfo>& endpoints);

}  // namespace galilean::wire
