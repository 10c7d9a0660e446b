// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/coverage/program_coverage.h"

#include <algorithm>
#include <cstdio>

#include "core/plural.h"
#include "core/state_change.h"
#include "core/visible_text.h"

namespace galilean::monitor {
namespace {

using Json = MessageTree;

constexpr std::size_t kMostDescribed = 100'000;  ///< more states or conditions has no real program
constexpr std::size_t kEntryBytes = 100;         ///< of a state or a condition, beside its texts

std::string dot_text(const std::string& text) {
  std::string quoted = "\"";
  for (const char letter : visible(text)) {
    if (letter == '"' || letter == '\\') quoted += '\\';
    quoted += letter;
  }
  return quoted + '"';
}

std::string percent(double share) {
  char text[16];
  std::snprintf(text, sizeof text, "%.0f %%", 100 * share);
  return text;
}

double share(std::size_t part, std::size_t all) {
  return all == 0 ? 1 : static_cast<double>(part) / static_cast<double>(all);
}

}  // namespace

std::string ProgramCoverage::Condition::text() const {
  return visible(file) + ':' + std::to_string(line) + ": " + visible(change_words(from, to)) +
         " when " + visible(variable) + '[' + std::to_string(bit) + "] is " + (value ? '1' : '0');
}

std::size_t ProgramCoverage::Condition::bytes() const noexcept {
  return kEntryBytes + from.size() + to.size() + file.size() + variable.size();
}

void ProgramCoverage::describe(const msg::Program& program) {
  name_ = program.name;
  if (described() || program.states.size() + program.transitions.size() > kMostDescribed) return;
  for (const auto& state : program.states) {
    states_in_order_.push_back(state.name);
    kept_bytes_ += kEntryBytes + state.name.size();
  }
  for (const auto& each : program.transitions)
    kept_bytes_ += conditions_in_order_
                       .emplace_back(Condition{each.from_state, each.to_state, each.file, each.line,
                                               each.bits_variable, each.bit_index, each.bit_value})
                       .bytes();
}

std::uint64_t& ProgramCoverage::visits_of(const std::string& state) {
  const auto [at, is_new] = visits_.try_emplace(state, 0);
  if (is_new) kept_bytes_ += kEntryBytes + state.size();
  return at->second;
}

ProgramCoverage::Counts& ProgramCoverage::counts_of(const Condition& condition) {
  const auto [at, is_new] = counts_.try_emplace(condition);
  if (is_new) kept_bytes_ += condition.bytes();
  return at->second;
}

void ProgramCoverage::note(const msg::RobotState& state) {
  if (name_.empty()) name_ = state.program_hash;
  if (visits_.size() < kMostDescribed) (void)visits_of(state.state);
}

/// A change without a condition is a swap of programs.
void ProgramCoverage::note(const msg::Transition& transition) {
  if (name_.empty()) name_ = transition.program_hash;
  if (visits_.size() >= kMostDescribed || counts_.size() >= kMostDescribed) return;
  ++visits_of(transition.to_state);
  if (transition.file.empty()) return;
  (void)visits_of(transition.from_state);
  const Condition taken{transition.from_state, transition.to_state,      transition.file,
                        transition.line,       transition.bits_variable, transition.bit_index,
                        transition.bit_value};
  ++counts_of(taken).taken;
  for (const auto& tested : transition.tested) {
    const Condition other{transition.from_state, tested.to_state,  tested.file,     tested.line,
                          tested.bits_variable,  tested.bit_index, tested.bit_value};
    if (tested.holds && other != taken) ++counts_of(other).held;
  }
}

std::size_t ProgramCoverage::visited() const {
  return static_cast<std::size_t>(std::ranges::count_if(
      states_in_order_, [&](const std::string& state) { return visits_.contains(state); }));
}

std::size_t ProgramCoverage::taken() const {
  return static_cast<std::size_t>(
      std::ranges::count_if(conditions_in_order_, [&](const Condition& condition) {
        const auto found = counts_.find(condition);
        return found != counts_.end() && found->second.taken > 0;
      }));
}

double ProgramCoverage::share_of_states() const {
  return share(visited(), states_in_order_.size());
}

double ProgramCoverage::share_of_conditions() const {
  return share(taken(), conditions_in_order_.size());
}

Json ProgramCoverage::figures() const {
  Json json{{"name", name_},
            {"described", described()},
            {"states", Json::array()},
            {"conditions", Json::array()}};
  auto states = states_in_order_;
  for (const auto& [state, visits] : visits_)
    if (std::ranges::find(states, state) == states.end()) states.push_back(state);
  for (const auto& state : states) {
    const auto visits = visits_.find(state);
    json["states"].push_back({{"name", state},
                              {"visited", visits != visits_.end()},
                              {"entered", visits == visits_.end() ? 0 : visits->second}});
  }
  for (const auto& condition : conditions_in_order_) {
    const auto found = counts_.find(condition);
    const Counts counts = found == counts_.end() ? Counts{} : found->second;
    json["conditions"].push_back({{"from", condition.from},
                                  {"to", condition.to},
                                  {"file", condition.file},
                                  {"line", condition.line},
                                  {"bits_variable", condition.variable},
                                  {"bit_index", condition.bit},
                                  {"bit_value", condition.value},
                                  {"taken", counts.taken},
                                  {"held_behind_another", counts.held}});
  }
  return json;
}

std::string ProgramCoverage::text() const {
  std::string text = visible(name_) + ": ";
  if (!described())
    return text + plural(visits_.size(), "state") +
           " visited; what else it has is not in the recordings\n";
  text += std::to_string(visited()) + " of " + plural(states_in_order_.size(), "state") + " (" +
          percent(share_of_states()) + "), " + std::to_string(taken()) + " of " +
          plural(conditions_in_order_.size(), "condition") + " (" + percent(share_of_conditions()) +
          ")\n";
  for (const auto& state : states_in_order_)
    if (!visits_.contains(state)) text += "  never in " + visible(state) + '\n';
  for (const auto& condition : conditions_in_order_) {
    const auto found = counts_.find(condition);
    if (found != counts_.end() && found->second.taken > 0) continue;
    text += "  never taken: " + condition.text();
    if (found != counts_.end())
      text += "; it held " + plural(found->second.held, "time") + " while another came first";
    text += '\n';
  }
  return text;
}

std::string ProgramCoverage::dot() const {
  std::string text = "digraph " + dot_text(name_) + " {\n  rankdir=LR;\n" +
                     "  node [shape=box, style=\"rounded,filled\", fillcolor=\"#d8f0d8\"];\n";
  for (const auto& state : states_in_order_) {
    text += "  " + dot_text(state);
    if (const auto found = visits_.find(state); found == visits_.end())
      text += " [style=\"rounded,dashed\"]";
    else if (found->second > 0)
      text += " [xlabel=\"" + std::to_string(found->second) + "\"]";
    text += ";\n";
  }
  std::map<std::pair<std::string, std::string>, std::uint64_t> ways;
  for (const auto& condition : conditions_in_order_) {
    const auto found = counts_.find(condition);
    ways[{condition.from, condition.to}] += found == counts_.end() ? 0 : found->second.taken;
  }
  for (const auto& [way, times] : ways)
    text += "  " + dot_text(way.first) + " -> " + dot_text(way.second) +
            (times > 0 ? " [label=\"" + std::to_string(times) + "\"];\n" : " [style=dashed];\n");
  return text + "}\n";
}

}  // namespace galilean::monitor
