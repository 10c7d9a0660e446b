// SPDX-License-Identifier: BSD-3-Clause
#include "bhdl/diff/diff.h"

#include "bhdl/diff/parts.h"

namespace galilean::bhdl {
namespace {

using ChangeKind = Change::Kind;

void compare_start(const Program& from, const Program& to, std::vector<Change>& changes) {
  if (from.start_state == to.start_state) return;
  Change change;
  change.what = Change::What::kStartState;
  change.from = from.start_state;
  change.to = to.start_state;
  changes.push_back(std::move(change));
}

void compare_swaps(const Program& from, const Program& to, std::vector<Change>& changes) {
  const auto add = [&](const std::string& old_state, const std::string* before,
                       const std::string* after) {
    Change change;
    change.what = Change::What::kOnSwap;
    change.kind = before == nullptr  ? ChangeKind::kAdded
                  : after != nullptr ? ChangeKind::kChanged
                                     : ChangeKind::kRemoved;
    change.name = old_state;
    if (before != nullptr) change.from = *before;
    if (after != nullptr) change.to = *after;
    changes.push_back(std::move(change));
  };
  for (const auto& [old_state, new_state] : from.on_swap) {
    const auto found = to.on_swap.find(old_state);
    if (found == to.on_swap.end())
      add(old_state, &new_state, nullptr);
    else if (found->second != new_state)
      add(old_state, &new_state, &found->second);
  }
  for (const auto& [old_state, new_state] : to.on_swap)
    if (!from.on_swap.contains(old_state)) add(old_state, nullptr, &new_state);
}

}  // namespace

std::vector<Change> differences(const Program& from, const Program& to, const Catalog& catalog) {
  using enum Change::What;
  const Vocabulary vocabulary(catalog);
  std::vector<Change> changes;
  compare_start(from, to, changes);
  compare_states(from.states, to.states, changes);
  compare_swaps(from, to, changes);
  compare_components(kDevice, from.devices, to.devices, vocabulary, changes);
  compare_components(kVariable, from.variables, to.variables, vocabulary, changes);
  compare_components(kPerceptualSchema, from.perceptual_schemas, to.perceptual_schemas, vocabulary,
                     changes);
  compare_components(kMotorSchema, from.motor_schemas, to.motor_schemas, vocabulary, changes);
  return changes;
}

}  // namespace galilean::bhdl
