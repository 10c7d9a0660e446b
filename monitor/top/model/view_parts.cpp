// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/top/model/view_parts.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <limits>
#include <map>

#include "core/wire/ros_time.h"
#include "core/wire/topic_names.h"
#include "monitor/top/model/break_marks.h"
#include "monitor/top/model/variable_text.h"

namespace galilean::monitor::top {
namespace {

constexpr double kInvalid = std::numeric_limits<double>::quiet_NaN();

const msg::Variable* variable_named(const msg::Variables& variables, const std::string& name) {
  const auto found = std::ranges::find(variables.items, name, &msg::Variable::name);
  return found == variables.items.end() ? nullptr : &*found;
}

std::optional<bool> bit_of(const msg::Variables& variables, const std::string& name,
                           std::uint32_t index) {
  const auto* variable = variable_named(variables, name);
  constexpr double kMostBits = 4294967296.0;
  if (!variable || !variable->valid || variable->values.empty() || index >= 32) return {};
  const double value = variable->values[0];
  if (!(value >= 0 && value < kMostBits)) return {};
  return ((static_cast<std::uint32_t>(value) >> index) & 1U) != 0;
}

template <class Condition>
std::string condition_text(const Condition& condition) {
  return condition.bits_variable + "[" + std::to_string(condition.bit_index) +
         "] = " + (condition.bit_value ? "1" : "0");
}

/// Returns the states to which conditions led that held, too, behind the one that fired.
std::vector<std::string> states_held_too(const msg::Transition& transition) {
  std::vector<std::string> states;
  bool fired = false;
  for (const auto& tested : transition.tested) {
    if (!tested.holds) continue;
    if (fired) states.push_back(tested.to_state);
    fired = true;
  }
  return states;
}

/// Returns the number that a variable's curve shows: a shaft's speed, a position's certainty, the
/// bits, or the length of a force.
double curve_value(const msg::Variable& variable) {
  namespace types = msg::Variable_Constants;
  const auto& v = variable.values;
  if (!variable.valid || v.empty()) return kInvalid;
  if (variable.type == types::SHAFT) return v.size() >= 4 ? v[3] : kInvalid;
  if (variable.type == types::LOCATE) return variable.certainty;
  if (variable.type == types::FORCE) return v.size() >= 2 ? std::hypot(v[0], v[1]) : kInvalid;
  return variable.type == types::BITS ? v[0] : kInvalid;
}

/// Returns each variable's curve, by its name.
std::map<std::string, std::vector<double>> curves_of(const Sources& sources, const Robot& robot) {
  constexpr std::size_t kMost = 48;
  std::map<std::string, std::vector<double>> curves;
  if (!sources.history) return curves;
  const auto topic = wire::robot_topic(robot.name, "variables");
  for (const auto& sample : sources.history->until(topic, sources.clock.now(), kMost)) {
    msg::Variables variables;
    if (!msg::decode_cdr(*sample.cdr, variables)) continue;
    for (const auto& variable : variables.items)
      curves[variable.name].push_back(curve_value(variable));
  }
  return curves;
}

}  // namespace

void show_machine(const Robot& robot, std::string_view chosen, View& view) {
  const std::string current = robot.state ? robot.state->state : "";
  const std::string before =
      robot.transitions.empty() || robot.transitions.back().to_state != current
          ? ""
          : robot.transitions.back().from_state;
  if (!robot.program) {
    if (!current.empty()) view.machine.states.push_back({current, true});
    return;
  }
  view.machine.program = robot.program->name;
  for (const auto& state : robot.program->states)
    view.machine.states.push_back(
        {state.name, state.name == current, state.name == before && before != current,
         mark_on_entering(robot.breaks, state.name), state.name == chosen});
  for (const auto& condition : robot.program->transitions)
    if (condition.from_state == current)
      view.machine.conditions.push_back(
          {condition_text(condition), condition.to_state,
           bit_of(robot.variables, condition.bits_variable, condition.bit_index),
           condition.bit_value, mark_at(robot.breaks, current, condition.to_state)});
}

void show_changes(const Robot& robot, double state_age_s, View& view) {
  const auto now_ns = robot.state ? wire::since_epoch_ns(robot.state->stamp) : 0;
  const msg::Transition* earlier = nullptr;
  for (const auto& transition : robot.transitions) {
    ShownChange change;
    change.ago_s =
        std::max(0.0, static_cast<double>(now_ns - wire::since_epoch_ns(transition.stamp)) * 1e-9 +
                          state_age_s);
    change.from_state = transition.from_state;
    change.to_state = transition.to_state;
    change.cause = transition.cause;
    // Its folders would leave no room for the line.
    if (!transition.file.empty())
      change.place = std::filesystem::path(transition.file).filename().string() + ":" +
                     std::to_string(transition.line);
    change.held_too = states_held_too(transition);
    if (earlier) change.missed = transition.number - earlier->number - 1;
    earlier = &transition;
    view.changes.insert(view.changes.begin(), std::move(change));
  }
}

void show_variables(const Sources& sources, const Robot& robot, std::string_view filter,
                    View& view) {
  view.known_variables = robot.variables.items.size();
  auto curves = curves_of(sources, robot);
  for (const auto& variable : robot.variables.items)
    if (contains(variable.name, filter))
      view.variables.push_back({variable.name, variable_text(variable),
                                sources.model.team().certainty_now(robot, variable),
                                std::move(curves[variable.name])});
}

}  // namespace galilean::monitor::top
