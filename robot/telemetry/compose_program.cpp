// SPDX-License-Identifier: BSD-3-Clause
#include "bhdl/source/sha256.h"
#include "robot/telemetry/compose.h"

namespace galilean::robot {
namespace {

msg::MachineState machine_state(const bhdl::State& state) {
  msg::MachineState made;
  made.name = state.name;
  made.file = state.location.file;
  made.line = static_cast<std::uint32_t>(state.location.line);
  made.perceptual_schemas = state.perceptual_schemas;
  made.motor_schemas = state.motor_schemas;
  return made;
}

msg::MachineTransition machine_transition(const bhdl::State& from,
                                          const bhdl::Condition& condition) {
  msg::MachineTransition made;
  made.from_state = from.name;
  made.to_state = condition.new_state;
  made.file = condition.location.file;
  made.line = static_cast<std::uint32_t>(condition.location.line);
  made.bits_variable = condition.bits_variable;
  made.bit_index = condition.bit_index;
  made.bit_value = condition.bit_value;
  made.bit_update = to_string(condition.bit_update);
  made.reset_variables = condition.reset_variables;
  return made;
}

}  // namespace

msg::Program Composer::program(const Description& program) const {
  msg::Program made;
  made.stamp = WallTime::now();
  made.robot = robot_;
  made.name = program.program.name;
  made.hash = program.program.hash;
  made.start_state = program.program.start_state;
  for (const auto& file : program.program.files) made.files.push_back({file.path, file.text});
  for (const auto& state : program.program.states) {
    made.states.push_back(machine_state(state));
    for (const auto& condition : state.conditions)
      made.transitions.push_back(machine_transition(state, condition));
  }
  return made;
}

msg::Catalog Composer::catalog(const galilean::Catalog& catalog) const {
  msg::Catalog made;
  made.robot = robot_;
  made.json = catalog_to_json(catalog);
  made.hash = bhdl::sha256(made.json);
  return made;
}

}  // namespace galilean::robot
