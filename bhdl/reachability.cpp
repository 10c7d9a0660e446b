#include "bhdl/reachability.h"

#include <string_view>
#include <unordered_map>
#include <vector>

#include "bhdl/text.h"

namespace galilean::bhdl {

void warn_of_unreachable_states(const Program& program, Diagnostics& diagnostics) {
  std::unordered_map<std::string_view, const State*> unreached;
  for (const auto& state : program.states) unreached.emplace(state.name, &state);
  std::vector<std::string_view> to_visit{program.start_state};
  for (const auto& [old_state, new_state] : program.on_swap) to_visit.push_back(new_state);
  while (!to_visit.empty()) {
    const auto found = unreached.find(to_visit.back());
    to_visit.pop_back();
    if (found == unreached.end()) continue;
    for (const auto& condition : found->second->conditions) to_visit.push_back(condition.new_state);
    unreached.erase(found);
  }
  for (const auto& state : program.states)
    if (unreached.contains(state.name))
      diagnostics.warning(state.location, "state/unreachable",
                          "no condition leads to the state " + in_quotes(state.name),
                          "name it as a new_state, or as 'start_state:'");
}

}  // namespace galilean::bhdl
