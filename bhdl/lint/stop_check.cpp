// SPDX-License-Identifier: BSD-3-Clause
#include "bhdl/lint/stop_check.h"

#include <algorithm>

#include "bhdl/source/text.h"
#include "core/device/device_names.h"

namespace galilean::bhdl {
namespace {

bool drives(const SchemaUses::Listed& listed) {
  return std::ranges::any_of(
      listed.motor, [](const SchemaUse* use) { return use->spec->drives == kMotorDriveName; });
}

/// Returns for each state whether it, or a state that it can get to, lets the motors stop.
std::vector<bool> can_stop(const Program& program, const SchemaUses& uses,
                           const StateGraph& graph) {
  const std::size_t count = program.states.size();
  std::vector<std::vector<std::size_t>> sources(count);
  std::vector<bool> stops(count);
  std::vector<std::size_t> to_visit;
  for (std::size_t state = 0; state < count; ++state) {
    for (const std::size_t target : graph.targets(state)) sources[target].push_back(state);
    if (drives(uses.listed(state))) continue;
    stops[state] = true;
    to_visit.push_back(state);
  }
  while (!to_visit.empty()) {
    const std::size_t state = to_visit.back();
    to_visit.pop_back();
    for (const std::size_t source : sources[state]) {
      if (stops[source]) continue;
      stops[source] = true;
      to_visit.push_back(source);
    }
  }
  return stops;
}

}  // namespace

void warn_of_endless_driving(const Program& program, const SchemaUses& uses,
                             const StateGraph& graph, Diagnostics& diagnostics) {
  if (graph.reached_states() < 2) return;
  const std::vector<bool> stops = can_stop(program, uses, graph);
  for (std::size_t i = 0; i < program.states.size(); ++i) {
    if (stops[i] || !graph.reached(i)) continue;
    const State& state = program.states[i];
    return diagnostics.warning(
        state.location, "state/never-stops",
        "the program cannot stop the motors after it enters " + in_quotes(state.name) +
            ": this state drives them, and so does every state that it leads to; the way there: " +
            graph.way_to(i),
        "add a condition that leads to a state without a driving schema",
        graph.places_on_way_to(i));
  }
}

}  // namespace galilean::bhdl
