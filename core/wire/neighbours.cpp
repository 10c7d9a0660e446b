// SPDX-License-Identifier: BSD-3-Clause
#include "core/wire/neighbours.h"

#include <set>

#include "core/wire/messages.h"
#include "core/wire/schemas.h"

namespace galilean::wire {

std::string owner_of(const std::string& topic) {
  const auto name = topic.substr(topic.find('/') + 1);
  return name.substr(0, name.find('/'));
}

Neighbours owners(const std::vector<EndpointInfo>& endpoints,
                  const std::function<bool(const EndpointInfo&)>& counts) {
  std::set<std::string> live, played;
  for (const auto& endpoint : endpoints)
    if (endpoint.writes && counts(endpoint))
      (endpoint.process == kReplayName ? played : live).insert(owner_of(endpoint.topic));
  return {{live.begin(), live.end()}, {played.begin(), played.end()}};
}

Neighbours robots_in(const std::vector<EndpointInfo>& endpoints) {
  const auto* state = find_schema_by_ros_type(msg::RobotState::kRosType);
  return owners(endpoints,
                [&](const auto& endpoint) { return endpoint.dds_type == state->dds_type; });
}

}  // namespace galilean::wire
