// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/expect/judge/evaluate.h"

#include <algorithm>
#include <cstdio>

#include "bhdl/source/text.h"
#include "monitor/expect/judge/reading.h"
#include "monitor/expect/language/measures.h"

namespace galilean::expect {
namespace {

std::string shown(const Comparison& comparison) {
  if (comparison.measure == Measure::kField) return comparison.topic.text + "." + comparison.field;
  const std::string name(spec_of(comparison.measure).name);
  return comparison.variable.empty() ? name : name + " of " + comparison.variable;
}

/// Returns a number with so many digits as people compare, and its unit.
std::string number_in(const Unit& unit, double si) {
  char digits[32];
  std::snprintf(digits, sizeof digits, "%.6g", si / unit.to_si);
  return unit.symbol.empty() ? digits : std::string(digits) + " " + std::string(unit.symbol);
}

const char* unknown_word(Truth truth) {
  return truth == Truth::kVoid ? "is invalid" : "is not known";
}

class Description {
 public:
  Description(const Belief& belief, std::int64_t at_ns) : belief_(belief), at_ns_(at_ns) {}

  std::string operator()(const Comparison& comparison) const {
    const auto reading = read_number(comparison, belief_, at_ns_);
    if (reading.truth != Truth::kTrue) return shown(comparison) + " " + unknown_word(reading.truth);
    return shown(comparison) + " is " + number_in(comparison.unit, reading.number);
  }
  std::string operator()(const NameIs& condition) const {
    constexpr const char* kNames[] = {"state", "program", "phase"};
    const bool field = condition.what == NameIs::What::kField;
    const std::string name = field ? condition.topic.text + "." + condition.field
                                   : kNames[static_cast<std::size_t>(condition.what)];
    const auto reading = read_name(condition, belief_, at_ns_);
    if (reading.truth != Truth::kTrue) return name + " is not known";
    return name + " is " + bhdl::in_quotes(reading.name);
  }
  std::string operator()(const RobotIs&) const {
    if (!belief_.knows_state(at_ns_)) return "state is not known";
    const auto& state = *belief_.state.message;
    if (!state.problems.empty()) return "problem: " + state.problems.front();
    return state.out_of_service ? "out of service"
           : state.held         ? "held"
           : state.in_probation ? "in probation"
                                : "healthy";
  }
  std::string operator()(const VariableIsValid& condition) const {
    const auto* variable = known_variable(belief_, condition.variable, at_ns_);
    if (!variable) return condition.variable + " is not known";
    const bool valid = variable->certainty_after(age_s(belief_, at_ns_)) > 0;
    return condition.variable + (valid ? " is valid" : " is invalid");
  }
  std::string operator()(const BitIs& condition) const {
    const auto value = evaluate({condition, {}}, belief_, at_ns_);
    const std::string name = condition.variable + "[" + std::to_string(condition.bit) + "]";
    if (!value.is_true() && !value.is_false()) return name + " " + unknown_word(value.truth);
    return name + " is " + (value.is_true() == condition.value ? "1" : "0");
  }
  std::string operator()(const Transition&) const {
    if (!belief_.event)
      return belief_.current_state.empty() ? ""
                                           : "state is " + bhdl::in_quotes(belief_.current_state);
    return "transition from " + bhdl::in_quotes(belief_.event->from_state) + " to " +
           bhdl::in_quotes(belief_.event->to_state) + ", because " +
           bhdl::in_quotes(belief_.event->cause);
  }
  template <class Other>
  std::string operator()(const Other&) const {
    return {};
  }

 private:
  const Belief& belief_;
  std::int64_t at_ns_;
};

}  // namespace

std::string describe(const Condition& condition, const Belief& belief, std::int64_t at_ns) {
  constexpr std::size_t kMost = 4;
  std::vector<std::string> parts;
  for_each_condition(condition, [&](const Condition& each) {
    if (parts.size() >= kMost) return;
    auto part = std::visit(Description(belief, at_ns), each.kind);
    if (!part.empty() && std::ranges::find(parts, part) == parts.end())
      parts.push_back(std::move(part));
  });
  std::string text;
  for (const auto& part : parts) text += (text.empty() ? "" : "; ") + part;
  return text;
}

std::optional<Unit> margin_unit(const Condition& condition) {
  std::optional<Unit> unit;
  bool several = false;
  for_each_condition(condition, [&](const Condition& each) {
    const auto* comparison = std::get_if<Comparison>(&each.kind);
    if (!comparison) return;
    several = several || (unit && unit->dimension != comparison->unit.dimension);
    if (!unit) unit = comparison->unit;
  });
  return several ? std::nullopt : unit;
}

}  // namespace galilean::expect
