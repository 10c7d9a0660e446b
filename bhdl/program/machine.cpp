// SPDX-License-Identifier: BSD-3-Clause
#include "bhdl/program/machine.h"

#include <nlohmann/json.hpp>

namespace galilean::bhdl {
namespace {

nlohmann::json state_to_json(const State& state) {
  return {{"name", state.name},
          {"file", state.location.file},
          {"line", state.location.line},
          {"perceptual_schemas", state.perceptual_schemas},
          {"motor_schemas", state.motor_schemas}};
}

nlohmann::json transition_to_json(const State& from, const Condition& condition) {
  return {{"from_state", from.name},
          {"to_state", condition.new_state},
          {"file", condition.location.file},
          {"line", condition.location.line},
          {"cause", cause(condition)},
          {"bits_variable", condition.bits_variable},
          {"bit_index", condition.bit_index},
          {"bit_value", condition.bit_value},
          {"bit_update", to_string(condition.bit_update)},
          {"reset_variables", condition.reset_variables}};
}

}  // namespace

std::string cause(const Condition& condition) {
  return condition.bits_variable + '[' + std::to_string(condition.bit_index) + "] is " +
         (condition.bit_value ? '1' : '0');
}

void to_json(nlohmann::json& json, const Program& program) {
  json = {{"name", program.name},
          {"hash", program.hash},
          {"start_state", program.start_state},
          {"states", nlohmann::json::array()},
          {"transitions", nlohmann::json::array()},
          {"on_swap", program.on_swap}};
  for (const auto& state : program.states) {
    json["states"].push_back(state_to_json(state));
    for (const auto& condition : state.conditions)
      json["transitions"].push_back(transition_to_json(state, condition));
  }
}

}  // namespace galilean::bhdl
