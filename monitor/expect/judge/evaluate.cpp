// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/expect/judge/evaluate.h"

#include <algorithm>
#include <cstdio>

#include "bhdl/source/text.h"
#include "monitor/expect/judge/reading.h"
#include "monitor/expect/language/measures.h"

namespace galilean::expect {
namespace {

bool fits(const std::string& wanted, const std::string& name) {
  return wanted.empty() || wanted == name;
}

bool matches(const Transition& wanted, const msg::Transition& event) {
  return fits(wanted.from, event.from_state) && fits(wanted.to, event.to_state) &&
         event.cause.find(wanted.cause) != std::string::npos;
}

bool is(RobotIs::What what, const msg::RobotState& state) {
  switch (what) {
    case RobotIs::What::kHealthy:
      return state.problems.empty();
    case RobotIs::What::kHeld:
      return state.held;
    case RobotIs::What::kInProbation:
      return state.in_probation;
    case RobotIs::What::kOutOfService:
      break;
  }
  return state.out_of_service;
}

class Evaluation {
 public:
  Evaluation(const Belief& belief, std::int64_t at_ns) : belief_(belief), at_ns_(at_ns) {}

  Value operator()(const AllOf& all) const {
    Value value = Value::of(true);
    for (const auto& part : all.parts) value = both(value, evaluate(part, belief_, at_ns_));
    return value;
  }
  Value operator()(const AnyOf& any) const {
    Value value = Value::of(false);
    for (const auto& part : any.parts) value = either(value, evaluate(part, belief_, at_ns_));
    return value;
  }
  Value operator()(const Not& negated) const {
    return !evaluate(negated.part.front(), belief_, at_ns_);
  }
  Value operator()(const Comparison& comparison) const {
    const auto reading = read_number(comparison, belief_, at_ns_);
    if (reading.truth != Truth::kTrue) return {reading.truth, 0};
    const double distance = margin(reading.number, comparison.op, comparison.limit);
    const bool held = holds(reading.number, comparison.op, comparison.limit);
    return {held ? Truth::kTrue : Truth::kFalse, distance};
  }
  Value operator()(const NameIs& condition) const {
    const auto reading = read_name(condition, belief_, at_ns_);
    if (reading.truth != Truth::kTrue) return {reading.truth, 0};
    return Value::of(std::ranges::find(condition.texts, reading.name) != condition.texts.end());
  }
  Value operator()(const RobotIs& condition) const {
    if (!belief_.knows_state(at_ns_)) return {};
    return Value::of(is(condition.what, *belief_.state.message));
  }
  Value operator()(const VariableIsValid& condition) const {
    const auto* variable = known_variable(belief_, condition.variable, at_ns_);
    return variable ? Value::of(variable->certainty_after(age_s(belief_, at_ns_)) > 0) : Value{};
  }
  Value operator()(const BitIs& condition) const {
    const auto* variable = known_variable(belief_, condition.variable, at_ns_);
    if (!variable || variable->type != msg::Variable_Constants::BITS || variable->values.empty())
      return {};
    if (variable->certainty_after(age_s(belief_, at_ns_)) <= 0) return {Truth::kVoid, 0};
    const double bits = variable->values.front();
    if (!(bits >= 0 && bits < 1.8e19)) return {};
    const bool value = (static_cast<std::uint64_t>(bits) >> condition.bit & 1) != 0;
    return Value::of(value == condition.value);
  }
  Value operator()(const Transition& condition) const {
    if (belief_.event) return Value::of(matches(condition, *belief_.event));
    return belief_.state.message ? Value::of(false) : Value{};
  }

 private:
  const Belief& belief_;
  std::int64_t at_ns_;
};

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
    const auto value = Evaluation(belief_, at_ns_)(condition);
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

Value evaluate(const Condition& condition, const Belief& belief, std::int64_t at_ns) {
  return std::visit(Evaluation(belief, at_ns), condition.kind);
}

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
