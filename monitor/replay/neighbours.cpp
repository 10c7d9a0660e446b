// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/replay/neighbours.h"

#include <set>
#include <string>

namespace galilean::monitor {

wire::Neighbours namesakes(const std::vector<wire::EndpointInfo>& endpoints,
                           const std::map<std::uint16_t, Track>& tracks) {
  std::set<std::string> topics;
  for (const auto& [channel, track] : tracks)
    if (!is_shared(track) && !is_made_by_monitor(track)) topics.insert(track.topic);
  return wire::owners(endpoints,
                      [&](const auto& endpoint) { return topics.contains(endpoint.topic); });
}

}  // namespace galilean::monitor
