// SPDX-License-Identifier: BSD-3-Clause
#include "bhdl/lint/state_graph.h"

#include <algorithm>

#include "bhdl/source/text.h"

namespace galilean::bhdl {
namespace {

constexpr std::size_t kLongestWay = 8;

}  // namespace

StateGraph::StateGraph(const Program& program)
    : program_(program), before_(program.states.size(), kNever) {
  for (std::size_t i = 0; i < program.states.size(); ++i)
    indices_.emplace(program.states[i].name, i);
  for (const auto& state : program.states) {
    auto& targets = targets_.emplace_back();
    for (const auto& condition : state.conditions) targets.push_back(index(condition.new_state));
  }
  if (const auto start = indices_.find(program.start_state); start != indices_.end())
    explore_from(start->second);
  for (const auto& [old_state, new_state] : program.on_swap) explore_from(index(new_state));
}

void StateGraph::explore_from(std::size_t beginning) {
  if (reached(beginning)) return;
  enter(beginning, beginning);
  for (std::size_t next = order_.size() - 1; next < order_.size(); ++next) {
    const std::size_t from = order_[next];
    for (const std::size_t target : targets_[from])
      if (!reached(target)) enter(target, from);
  }
}

void StateGraph::enter(std::size_t state, std::size_t from) {
  before_[state] = from;
  order_.push_back(state);
}

std::vector<std::size_t> StateGraph::short_way_to(std::size_t state) const {
  std::vector<std::size_t> way{state};
  while (before_[way.back()] != way.back()) way.push_back(before_[way.back()]);
  std::ranges::reverse(way);
  if (way.size() > kLongestWay) {
    const auto first = way.begin() + kLongestWay / 2;
    *first = kLeftOut;
    way.erase(first + 1, way.end() - kLongestWay / 2);
  }
  return way;
}

std::string StateGraph::way_to(std::size_t state) const {
  std::string text;
  for (const std::size_t each : short_way_to(state)) {
    if (!text.empty()) text += " → ";
    text += each == kLeftOut ? "…" : program_.states[each].name;
  }
  return text;
}

std::vector<RelatedPlace> StateGraph::places_on_way_to(std::size_t state) const {
  std::vector<RelatedPlace> places;
  for (const std::size_t each : short_way_to(state)) {
    if (each == kLeftOut) continue;
    const State& passed = program_.states[each];
    places.push_back({passed.location, (places.empty() ? "the way there begins in " : "then ") +
                                           in_quotes(passed.name)});
  }
  return places;
}

}  // namespace galilean::bhdl
