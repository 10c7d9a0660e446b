// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/simulation/simulations.h"

#include <utility>

#include "core/plural.h"

namespace galilean::monitor {

void Simulations::note(msg::SimulationState state, Time now) {
  constexpr std::size_t kMost = 64;  // Anybody can name simulations that are not there.
  const std::string name = state.simulation;
  if (heard_.size() >= kMost && !heard_.contains(name))
    std::erase_if(heard_, [&](const auto& each) { return now - each.second.at > kSilentAfter; });
  if (heard_.size() >= kMost && !heard_.contains(name)) return;
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
    return Error{"simulation '" + name + "' is not heard; heard " + agreeing(live, "is ", "are ") +
                 names};
  if (live > 1) return Error{"several simulations are heard; name one of them: " + names};
  return found;
}

}  // namespace galilean::monitor
