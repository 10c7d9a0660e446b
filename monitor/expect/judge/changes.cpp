// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/expect/judge/evaluate.h"

namespace galilean::expect {
namespace {

/// Adds the instant and the next: at the first one <= changes, at the second <.
class Changes {
 public:
  Changes(std::int64_t after_ns, std::int64_t before_ns, std::vector<std::int64_t>& instants)
      : after_ns_(after_ns), before_ns_(before_ns), instants_(instants) {}
  void add(std::int64_t at_ns) const {
    for (const auto each : {at_ns, at_ns + 1})
      if (each > after_ns_ && each < before_ns_) instants_.push_back(each);
  }
  void add_in(std::int64_t from_ns, double seconds) const {
    constexpr double kNever_s = 1e9;
    if (seconds >= 0 && seconds < kNever_s) add(from_ns + static_cast<std::int64_t>(seconds * 1e9));
  }
  /// Adds when the certainty falls to `limit`.
  void add_decay(const Belief& belief, std::string_view name, double limit) const {
    const auto found = belief.variables.find(name);
    if (found == belief.variables.end() || !belief.variables_ns) return;
    const auto& variable = found->second;
    if (!variable.valid || variable.decay_per_s <= 0) return;
    add_in(*belief.variables_ns, (variable.certainty - limit) / variable.decay_per_s);
  }

 private:
  std::int64_t after_ns_, before_ns_;
  std::vector<std::int64_t>& instants_;
};

}  // namespace

void add_changes(const Condition& condition, const Belief& belief, std::int64_t after_ns,
                 std::int64_t before_ns, std::vector<std::int64_t>& instants) {
  const Changes changes(after_ns, before_ns, instants);
  for_each_condition(condition, [&](const Condition& each) {
    if (const auto* comparison = std::get_if<Comparison>(&each.kind)) {
      if (!comparison->variable.empty()) changes.add_decay(belief, comparison->variable, 0);
      if (comparison->measure == Measure::kCertainty)
        changes.add_decay(belief, comparison->variable, comparison->limit);
    } else if (const auto* valid = std::get_if<VariableIsValid>(&each.kind)) {
      changes.add_decay(belief, valid->variable, 0);
    } else if (const auto* bit = std::get_if<BitIs>(&each.kind)) {
      changes.add_decay(belief, bit->variable, 0);
    }
  });
  if (belief.state.message) changes.add(belief.state.at_ns + belief.silence_ns);
  if (belief.variables_ns) changes.add(*belief.variables_ns + belief.silence_ns);
}

}  // namespace galilean::expect
