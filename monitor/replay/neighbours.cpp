// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/replay/neighbours.h"

#include <algorithm>
#include <set>

#include "core/wire/messages.h"
#include "core/wire/participant.h"
#include "core/wire/schemas.h"

namespace galilean::monitor {
namespace {

/// Returns the owners of the topics that are written and that `counts` accepts.
template <class Counts>
Neighbours owners(const std::vector<wire::EndpointInfo>& endpoints, Counts counts) {
  std::set<std::string> live, played;
  for (const auto& endpoint : endpoints)
    if (endpoint.writes && counts(endpoint))
      (endpoint.process == wire::kReplayName ? played : live).insert(owner_of(endpoint.topic));
  return {{live.begin(), live.end()}, {played.begin(), played.end()}};
}

}  // namespace

Neighbours namesakes(const std::vector<wire::EndpointInfo>& endpoints,
                     const std::map<std::uint16_t, Track>& tracks) {
  std::set<std::string> topics;
  for (const auto& [channel, track] : tracks)
    if (!is_shared(track) && !is_made_by_monitor(track)) topics.insert(track.topic);
  return owners(endpoints, [&](const auto& endpoint) { return topics.contains(endpoint.topic); });
}

Neighbours robots_in(const std::vector<wire::EndpointInfo>& endpoints) {
  const auto* state = wire::find_schema_by_ros_type(msg::RobotState::kRosType);
  return owners(endpoints,
                [&](const auto& endpoint) { return endpoint.dds_type == state->dds_type; });
}

}  // namespace galilean::monitor
