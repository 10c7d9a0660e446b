// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/expect/judge/evaluate.h"

#include <algorithm>

#include "monitor/expect/judge/reading.h"

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

}  // namespace

Value evaluate(const Condition& condition, const Belief& belief, std::int64_t at_ns) {
  return std::visit(Evaluation(belief, at_ns), condition.kind);
}

}  // namespace galilean::expect
