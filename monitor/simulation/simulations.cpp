// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/simulation/simulations.h"

#include <utility>

namespace galilean::monitor {

void Simulations::note(msg::SimulationState state, Time now) {
  const std::string name = state.simulation;
  heard_[name] = {std::move(state), now};
}

Result<const msg::SimulationState*> Simulations::find(const std::string& name, Time now) const {
  std::string names;
  const msg::SimulationState* found = nullptr;
  std::size_t live = 0;
  for (const auto& [each, heard] : heard_) {
    if (now - heard.at > kSilentAfter) continue;
    if (each == name) return &heard.state;
    names += (names.empty() ? "" : ", ") + each;
    found = &heard.state;
    ++live;
  }
  if (live == 0)
    return Error{
        "no simulation is heard; check that galilean demo or galilean sim --live runs in the same "
        "DDS domain (--domain, ROS_DOMAIN_ID)"};
  if (!name.empty())
    return Error{"simulation '" + name + "' is not heard; heard " + (live == 1 ? "is " : "are ") +
                 names};
  if (live > 1) return Error{"several simulations are heard; name one of them: " + names};
  return found;
}

}  // namespace galilean::monitor
