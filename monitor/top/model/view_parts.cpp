// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/top/model/view_parts.h"

#include <algorithm>
#include <cstdint>

#include "core/wire/ros_time.h"
#include "monitor/top/model/break_marks.h"
#include "monitor/top/model/variable_text.h"

namespace galilean::monitor::top {
namespace {

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
      change.place = transition.file.substr(transition.file.rfind('/') + 1) + ":" +
                     std::to_string(transition.line);
    change.held_too = states_held_too(transition);
    if (earlier) change.missed = transition.number - earlier->number - 1;
    change.filled = robot.is_filled(transition.number);
    earlier = &transition;
    view.changes.push_back(std::move(change));
  }
  std::ranges::reverse(view.changes);
}

void show_variables(const Sources& sources, const Robot& robot, std::string_view filter,
                    View& view) {
  view.known_variables = robot.variables.items.size();
  std::vector<std::vector<double>> curves(robot.variables.items.size());
  if (sources.curves) curves = sources.curves->of(robot, sources.clock.now());
  for (std::size_t i = 0; i < curves.size(); ++i) {
    const auto& variable = robot.variables.items[i];
    if (contains(variable.name, filter))
      view.variables.push_back({variable.name, variable_text(variable),
                                sources.model.team().certainty_now(robot, variable),
                                std::move(curves[i])});
  }
}

}  // namespace galilean::monitor::top
