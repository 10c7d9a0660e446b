// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <unordered_map>
#include <unordered_set>

#include "bhdl/diff/parts.h"

namespace galilean::bhdl {
namespace {

using List = std::vector<std::string>;

class StateListComparison {
 public:
  StateListComparison(const std::string& state, const std::string& attribute,
                      std::vector<Change>& changes)
      : state_(state), attribute_(attribute), changes_(changes) {}

  void run(const List& from, const List& to) {
    const List gone = without(from, to);
    const List added = without(to, from);
    for (const auto& name : gone) add(Change::Kind::kRemoved, Value(name), std::nullopt);
    for (const auto& name : added) add(Change::Kind::kAdded, std::nullopt, Value(name));
    const List kept_before = without(from, gone);
    const List kept_after = without(to, added);
    if (kept_before != kept_after)
      add(Change::Kind::kReordered, Value(kept_before), Value(kept_after));
  }

 private:
  static List without(const List& names, const List& unwanted) {
    const std::unordered_set<std::string_view> out(unwanted.begin(), unwanted.end());
    List kept;
    std::ranges::copy_if(names, std::back_inserter(kept),
                         [&](const std::string& name) { return !out.contains(name); });
    return kept;
  }

  void add(Change::Kind kind, std::optional<Value> from, std::optional<Value> to) {
    Change change;
    change.kind = kind;
    change.what = Change::What::kState;
    change.name = state_;
    change.attribute = attribute_;
    change.from = std::move(from);
    change.to = std::move(to);
    changes_.push_back(std::move(change));
  }

  const std::string& state_;
  std::string attribute_;
  std::vector<Change>& changes_;
};

void compare_state(const State& from, const State& to, std::vector<Change>& changes) {
  StateListComparison(to.name, "perceptual_schemas", changes)
      .run(from.perceptual_schemas, to.perceptual_schemas);
  StateListComparison(to.name, "motor_schemas", changes).run(from.motor_schemas, to.motor_schemas);
  compare_conditions(from, to, changes);
}

std::unordered_map<std::string_view, const State*> by_name(const std::vector<State>& states) {
  std::unordered_map<std::string_view, const State*> index;
  for (const auto& state : states) index.emplace(state.name, &state);
  return index;
}

void add_state(Change::Kind kind, const State& state, std::vector<Change>& changes) {
  Change change;
  change.kind = kind;
  change.what = Change::What::kState;
  change.name = state.name;
  changes.push_back(std::move(change));
  const State none;
  const bool added = kind == Change::Kind::kAdded;
  compare_conditions(added ? none : state, added ? state : none, changes);
}

}  // namespace

void compare_states(const std::vector<State>& from, const std::vector<State>& to,
                    std::vector<Change>& changes) {
  const auto before = by_name(from);
  const auto after = by_name(to);
  for (const auto& state : from) {
    const auto found = after.find(state.name);
    if (found == after.end())
      add_state(Change::Kind::kRemoved, state, changes);
    else
      compare_state(state, *found->second, changes);
  }
  for (const auto& state : to)
    if (!before.contains(state.name)) add_state(Change::Kind::kAdded, state, changes);
}

}  // namespace galilean::bhdl
