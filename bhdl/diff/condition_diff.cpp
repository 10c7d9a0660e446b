// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <deque>
#include <unordered_map>

#include "bhdl/diff/parts.h"
#include "bhdl/program/machine.h"

namespace galilean::bhdl {
namespace {

using Key = std::string (*)(const Condition&);

// The line end separates the parts, because no name holds one.
std::string test_key(const Condition& condition) {
  return cause(condition) + '\n';
}

std::string whole_key(const Condition& condition) {
  std::string key = test_key(condition) + std::string(to_string(condition.bit_update)) + '\n' +
                    condition.new_state;
  for (const auto& variable : condition.reset_variables) key += '\n' + variable;
  return key;
}

std::string way_key(const Condition& condition) {
  return condition.bits_variable + '\n' + condition.new_state;
}

std::string arrow(const Condition& condition) {
  return cause(condition) + " -> " + condition.new_state;
}

/// Pairs the conditions of two states, because conditions have no names. Two are the same if all of
/// them is equal; else if they test the same bit; else if the same variable leads to the same
/// state.
class ConditionComparison {
 public:
  ConditionComparison(const State& from, const State& to, std::vector<Change>& changes)
      : from_(from),
        to_(to),
        changes_(changes),
        partner_(from.conditions.size(), kNone),
        is_taken_(to.conditions.size(), false) {}

  void run() {
    for (const Key key : {whole_key, test_key, way_key}) match(key);
    for (std::size_t i = 0; i < partner_.size(); ++i) {
      if (partner_[i] == kNone)
        add_whole_transition(Change::Kind::kRemoved, from_, from_.conditions[i]);
      else
        compare(from_.conditions[i], to_.conditions[partner_[i]]);
    }
    for (std::size_t i = 0; i < is_taken_.size(); ++i)
      if (!is_taken_[i]) add_whole_transition(Change::Kind::kAdded, to_, to_.conditions[i]);
    compare_order();
  }

 private:
  static constexpr std::size_t kNone = static_cast<std::size_t>(-1);

  void match(Key key) {
    std::unordered_map<std::string, std::deque<std::size_t>> free;
    for (std::size_t i = 0; i < is_taken_.size(); ++i)
      if (!is_taken_[i]) free[key(to_.conditions[i])].push_back(i);
    for (std::size_t i = 0; i < partner_.size(); ++i) {
      if (partner_[i] != kNone) continue;
      const auto found = free.find(key(from_.conditions[i]));
      if (found == free.end() || found->second.empty()) continue;
      partner_[i] = found->second.front();
      is_taken_[partner_[i]] = true;
      found->second.pop_front();
    }
  }

  void compare(const Condition& from, const Condition& to) {
    compare(from, "bit_index", Value(double(from.bit_index)), Value(double(to.bit_index)));
    compare(from, "bit_value", Value(from.bit_value), Value(to.bit_value));
    compare(from, "bit_update", Value(std::string(to_string(from.bit_update))),
            Value(std::string(to_string(to.bit_update))));
    compare(from, "new_state", Value(from.new_state), Value(to.new_state));
    compare(from, "reset_variables", Value(from.reset_variables), Value(to.reset_variables));
  }

  void compare(const Condition& condition, const std::string& attribute, Value from, Value to) {
    if (from == to) return;
    Change change = transition(Change::Kind::kChanged, from_, condition);
    change.attribute = attribute;
    change.from = std::move(from);
    change.to = std::move(to);
    changes_.push_back(std::move(change));
  }

  void compare_order() {
    std::vector<std::size_t> order;
    for (const std::size_t each : partner_)
      if (each != kNone) order.push_back(each);
    if (std::ranges::is_sorted(order)) return;
    Change change;
    change.kind = Change::Kind::kReordered;
    change.name = to_.name;
    change.attribute = "conditions";
    std::vector<std::string> before, after;
    for (const std::size_t each : order) before.push_back(arrow(to_.conditions[each]));
    std::ranges::sort(order);
    for (const std::size_t each : order) after.push_back(arrow(to_.conditions[each]));
    change.from = std::move(before);
    change.to = std::move(after);
    changes_.push_back(std::move(change));
  }

  static Change transition(Change::Kind kind, const State& state, const Condition& condition) {
    Change change;
    change.kind = kind;
    change.what = Change::What::kTransition;
    change.name = state.name;
    change.transition = cause(condition);
    return change;
  }

  void add_whole_transition(Change::Kind kind, const State& state, const Condition& condition) {
    Change change = transition(kind, state, condition);
    (kind == Change::Kind::kAdded ? change.to : change.from) = condition.new_state;
    changes_.push_back(std::move(change));
  }

  const State& from_;
  const State& to_;
  std::vector<Change>& changes_;
  std::vector<std::size_t> partner_;  ///< for each condition of `from_`, its index in `to_`
  std::vector<bool> is_taken_;
};

}  // namespace

void compare_conditions(const State& from, const State& to, std::vector<Change>& changes) {
  ConditionComparison(from, to, changes).run();
}

}  // namespace galilean::bhdl
