// SPDX-License-Identifier: BSD-3-Clause
#include "bhdl/lint/condition_check.h"

#include <map>

#include "bhdl/lint/bit_flow.h"
#include "bhdl/source/text.h"

namespace galilean::bhdl {
namespace {

constexpr std::size_t kMostBits = 256;

TestedBit bit_of(const Condition& condition) noexcept {
  return {condition.bits_variable, condition.bit_index};
}

std::string bit_in_words(const TestedBit& bit) {
  return "bit " + std::to_string(bit.index) + " of " + in_quotes(bit.variable);
}

class ConditionChecker {
 public:
  ConditionChecker(const Program& program, const SchemaUses& uses, const StateGraph& graph,
                   Diagnostics& diagnostics)
      : program_(program), uses_(uses), graph_(graph), diagnostics_(diagnostics) {}

  void check() {
    for (std::size_t state = 0; state < program_.states.size(); ++state) {
      if (!graph_.reached(state)) continue;
      std::map<std::pair<TestedBit, bool>, const Condition*> tried;
      for (const auto& condition : program_.states[state].conditions) {
        const auto [first, is_new] =
            tried.try_emplace({bit_of(condition), condition.bit_value}, &condition);
        if (is_new)
          tests_[bit_of(condition)].push_back({state, &condition});
        else
          warn_of_second(condition, *first->second);
      }
    }
    if (tests_.size() > kMostBits) tests_.erase(std::next(tests_.begin(), kMostBits), tests_.end());
    std::vector<std::size_t> tested;
    for (const auto& [bit, tests] : tests_) tested.push_back(uses_.variable(bit.variable));
    const WritersOfTested writers = writers_of_tested(program_, uses_, tested);
    for (const auto& [bit, tests] : tests_)
      check(tests, bit, BitFlow(program_, graph_, writers.at(uses_.variable(bit.variable)), bit));
  }

 private:
  struct Test {
    std::size_t state = 0;
    const Condition* condition = nullptr;
  };

  void check(const std::vector<Test>& tests, const TestedBit& bit, const BitFlow& flow) {
    for (const auto& test : tests) {
      const BitValues values = flow.within(test.state);
      if (values == 0) continue;
      const BitValues holds = bit_values_of(test.condition->bit_value);
      if ((values & holds) == 0) warn_of_never(test, bit, values);
      if (values == holds) warn_of_always(test, bit);
    }
  }

  void warn_of_second(const Condition& condition, const Condition& first) {
    diagnostics_.warning(condition.location, "condition/never",
                         "this condition never fires: the condition in line " +
                             std::to_string(first.location.line) +
                             " tests the same bit for the same value first",
                         "take one of them away, or test another bit");
  }

  void warn_of_never(const Test& test, const TestedBit& bit, BitValues values) {
    const bool invalid = (values & (kBitZero | kBitOne)) == 0;
    const std::string& state = program_.states[test.state].name;
    diagnostics_.warning(
        test.condition->location, "condition/never",
        "this condition never holds: " +
            (invalid ? in_quotes(bit.variable) + " is always invalid"
                     : bit_in_words(bit) + " is never " + (test.condition->bit_value ? "1" : "0")) +
            " in the state " + in_quotes(state) + way_to(test.state),
        "list a schema that writes " + bit_in_words(bit) + " in " + in_quotes(state),
        places_on_way_to(test.state));
  }

  void warn_of_always(const Test& test, const TestedBit& bit) {
    const std::string& state = program_.states[test.state].name;
    diagnostics_.warning(
        test.condition->location, "condition/always",
        "this condition always holds: " + bit_in_words(bit) + " is always " +
            (test.condition->bit_value ? "1" : "0") + " in the state " + in_quotes(state) +
            ", which is left in its first tick" + way_to(test.state),
        "list a schema that writes " + bit_in_words(bit) + " in " + in_quotes(state),
        places_on_way_to(test.state));
  }

  // A way may be as long as the program, so that it is not looked for if the warning will not be
  // kept.
  [[nodiscard]] std::string way_to(std::size_t state) const {
    return diagnostics_.full_of_warnings() ? std::string()
                                           : "; the way there: " + graph_.way_to(state);
  }

  [[nodiscard]] std::vector<RelatedPlace> places_on_way_to(std::size_t state) const {
    return diagnostics_.full_of_warnings() ? std::vector<RelatedPlace>()
                                           : graph_.places_on_way_to(state);
  }

  const Program& program_;
  const SchemaUses& uses_;
  const StateGraph& graph_;
  Diagnostics& diagnostics_;
  std::map<TestedBit, std::vector<Test>> tests_;
};

}  // namespace

void warn_of_certain_conditions(const Program& program, const SchemaUses& uses,
                                const StateGraph& graph, Diagnostics& diagnostics) {
  ConditionChecker(program, uses, graph, diagnostics).check();
}

}  // namespace galilean::bhdl
