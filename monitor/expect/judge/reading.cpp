// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/expect/judge/reading.h"

#include <cmath>

#include "monitor/expect/language/measures.h"
#include "monitor/wire/message_text.h"

namespace galilean::expect {
namespace {

namespace type = msg::Variable_Constants;

Reading known(double number) {
  return std::isfinite(number) ? Reading{Truth::kTrue, number} : Reading{Truth::kMissing, 0};
}

Reading robot_number(Measure measure, const Belief& belief, std::int64_t at_ns) {
  if (!belief.knows_state(at_ns)) return {};
  const auto& state = *belief.state.message;
  switch (measure) {
    case Measure::kRobotX:
      return known(state.x_m);
    case Measure::kRobotY:
      return known(state.y_m);
    case Measure::kRobotHeading:
      return known(state.heading_rad);
    case Measure::kTickTime:
      return known(static_cast<double>(state.tick_time_max_us) * 1e-6);
    case Measure::kTickOverruns:
      return known(state.overruns);
    default:
      return known(static_cast<double>(state.problems.size()));
  }
}

Reading score_number(Measure measure, const Belief& belief) {
  if (!belief.team->score.message) return {};
  const auto& score = *belief.team->score.message;
  if (measure == Measure::kPoints) return known(score.points);
  if (measure == Measure::kElapsed) return known(score.elapsed_s);
  if (measure == Measure::kRemaining) return known(score.remaining_s);
  const bool deposited = measure == Measure::kDeposited;
  if (belief.robot.empty()) return known(deposited ? score.deposited : score.collisions);
  for (const auto& robot : score.robots)
    if (robot.robot == belief.robot) return known(deposited ? robot.deposited : robot.collisions);
  return {};
}

Reading value_at(const KnownVariable& variable, std::size_t index) {
  return index < variable.values.size() ? known(variable.values[index]) : Reading{};
}

Reading distance_to(const KnownVariable& variable, const Belief& belief, std::int64_t at_ns) {
  if (!belief.knows_state(at_ns) || variable.values.size() < 2) return {};
  const auto& state = *belief.state.message;
  return known(std::hypot(variable.values[0] - state.x_m, variable.values[1] - state.y_m));
}

/// Returns the value of a variable that is valid. What a variable of its type does not have is
/// missing.
Reading value_of(Measure measure, const KnownVariable& variable, const Belief& belief,
                 std::int64_t at_ns) {
  const bool is_shaft = variable.type == type::SHAFT, is_place = variable.type == type::LOCATE;
  const bool is_force = variable.type == type::FORCE;
  switch (measure) {
    case Measure::kVariableX:
      return is_shaft || is_place ? value_at(variable, 0) : Reading{};
    case Measure::kVariableY:
      return is_shaft || is_place ? value_at(variable, 1) : Reading{};
    case Measure::kDistance:
      return is_place ? distance_to(variable, belief, at_ns) : Reading{};
    case Measure::kRadius:
      return is_place ? value_at(variable, 5) : Reading{};
    case Measure::kVariableHeading:
      return is_shaft ? value_at(variable, 2) : Reading{};
    case Measure::kSpeed:
      return is_shaft ? value_at(variable, 3) : Reading{};
    case Measure::kTurnRate:
      return is_shaft ? value_at(variable, 4) : Reading{};
    case Measure::kForceX:
      return is_force ? value_at(variable, 0) : Reading{};
    default:
      return is_force ? value_at(variable, 1) : Reading{};
  }
}

Reading variable_number(const Comparison& comparison, const Belief& belief, std::int64_t at_ns) {
  const auto* variable = known_variable(belief, comparison.variable, at_ns);
  if (!variable) return {};
  const double certainty = variable->certainty_after(age_s(belief, at_ns));
  if (comparison.measure == Measure::kCertainty) return known(certainty);
  if (certainty <= 0) return {Truth::kVoid, 0};
  return value_of(comparison.measure, *variable, belief, at_ns);
}

/// Returns the field, or nullptr if the topic, the field or the index is not there.
const monitor::MessageTree* find(const TopicName& topic, const std::string& field,
                                 const Belief& belief) {
  const auto message = belief.team->fields.find(topic.of(belief.robot));
  if (message == belief.team->fields.end()) return nullptr;
  const auto found = monitor::find_field(message->second, field);
  return found ? found.value() : nullptr;
}

Reading field_number(const Comparison& comparison, const Belief& belief) {
  const auto* field = find(comparison.topic, comparison.field, belief);
  if (!field || !(field->is_number() || field->is_boolean())) return {};
  const double number = field->is_boolean() ? field->get<bool>() : field->get<double>();
  return known(number * unit_of_field(comparison.field).to_si);
}

}  // namespace

double age_s(const Belief& belief, std::int64_t at_ns) {
  return belief.variables_ns ? static_cast<double>(at_ns - *belief.variables_ns) * 1e-9 : 0;
}

const KnownVariable* known_variable(const Belief& belief, std::string_view name,
                                    std::int64_t at_ns) {
  if (!belief.knows_variables(at_ns)) return nullptr;
  const auto found = belief.variables.find(name);
  const bool heard = found != belief.variables.end() && found->second.type != 0;
  return heard ? &found->second : nullptr;
}

Reading read_number(const Comparison& comparison, const Belief& belief, std::int64_t at_ns) {
  if (comparison.measure == Measure::kField) return field_number(comparison, belief);
  switch (spec_of(comparison.measure).of) {
    case MeasureSpec::Of::kRobot:
      return robot_number(comparison.measure, belief, at_ns);
    case MeasureSpec::Of::kScore:
      return score_number(comparison.measure, belief);
    case MeasureSpec::Of::kVariable:
      break;
  }
  return variable_number(comparison, belief, at_ns);
}

NameReading read_name(const NameIs& condition, const Belief& belief, std::int64_t at_ns) {
  switch (condition.what) {
    case NameIs::What::kState:
      if (!belief.knows_state(at_ns)) return {};
      return {Truth::kTrue, belief.current_state};
    case NameIs::What::kProgram:
      if (!belief.knows_state(at_ns)) return {};
      return {Truth::kTrue, belief.state.message->program_name};
    case NameIs::What::kPhase:
      if (!belief.team->score.message) return {};
      return {Truth::kTrue, belief.team->score.message->phase};
    case NameIs::What::kField:
      break;
  }
  const auto* field = find(condition.topic, condition.field, belief);
  if (!field || !field->is_string()) return {};
  return {Truth::kTrue, field->get_ref<const std::string&>()};
}

}  // namespace galilean::expect
