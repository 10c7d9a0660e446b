// SPDX-License-Identifier: BSD-3-Clause
#include "bhdl/lint/reachability.h"

#include <algorithm>

#include "bhdl/source/text.h"

namespace galilean::bhdl {

void warn_of_unreachable_states(const Program& program, const StateGraph& graph,
                                const ExtendedNames& extended, Diagnostics& diagnostics) {
  for (std::size_t i = 0; i < program.states.size(); ++i)
    if (!graph.reached(i) && !extended.states.contains(program.states[i].name))
      diagnostics.warning(program.states[i].location, "state/unreachable",
                          "no condition leads to the state " + in_quotes(program.states[i].name),
                          "name it as a new_state, or as 'start_state:'");
}

void warn_of_dead_ends(const Program& program, const StateGraph& graph, Diagnostics& diagnostics) {
  if (graph.reached_states() < 2) return;
  for (std::size_t i = 0; i < program.states.size(); ++i) {
    const State& state = program.states[i];
    const bool rests = state.conditions.empty() && state.motor_schemas.empty();
    const auto stays = [&](const Condition& each) { return each.new_state == state.name; };
    if (!graph.reached(i) || rests || !std::ranges::all_of(state.conditions, stays)) continue;
    const bool shown = !diagnostics.full_of_warnings();
    diagnostics.warning(state.location, "state/trap",
                        "the state " + in_quotes(state.name) + " is never left for another" +
                            (shown ? "; the way there: " + graph.way_to(i) : std::string()),
                        "give it a condition with another 'new_state:'",
                        shown ? graph.places_on_way_to(i) : std::vector<RelatedPlace>());
  }
}

}  // namespace galilean::bhdl
