// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "core/wire/messages.h"
#include "tests/monitor/expect/recording/recorded_team.h"

namespace galilean::monitor {

/// A program with three states and three conditions, of which two lead from "wander".
inline msg::Program fetch() {
  msg::Program program;
  program.name = "fetch";
  program.hash = "3f2a";
  program.start_state = "wander";
  for (const char* name : {"wander", "grab", "flee"}) program.states.emplace_back().name = name;
  const auto add = [&](const char* from, const char* to, std::uint32_t line) {
    auto& condition = program.transitions.emplace_back();
    condition.from_state = from;
    condition.to_state = to;
    condition.file = "fetch.bhdl";
    condition.line = line;
    condition.bits_variable = "bumpers";
    condition.bit_value = true;
  };
  add("wander", "grab", 5);
  add("wander", "flee", 6);
  add("grab", "wander", 9);
  return program;
}

/// The transition by a condition of the program, during which others held, too.
inline msg::Transition taken(const msg::MachineTransition& by,
                             const std::vector<msg::MachineTransition>& held = {}) {
  msg::Transition transition;
  transition.robot = "io";
  transition.program_hash = "3f2a";
  transition.from_state = by.from_state;
  transition.to_state = by.to_state;
  transition.file = by.file;
  transition.line = by.line;
  transition.bits_variable = by.bits_variable;
  transition.bit_value = by.bit_value;
  for (const auto& other : held) {
    auto& tested = transition.tested.emplace_back();
    tested.to_state = other.to_state;
    tested.file = other.file;
    tested.line = other.line;
    tested.bits_variable = other.bits_variable;
    tested.bit_value = other.bit_value;
    tested.holds = true;
  }
  return transition;
}

/// Returns a recording of io that runs fetch(): it goes to "grab" and back, while the way to "flee"
/// is open too. The program comes last, as it may.
inline mcap::Bytes recording_of_fetch() {
  const auto program = fetch();
  expect::RecordedTeam team;
  msg::RobotState state;
  state.robot = "io";
  state.program_hash = program.hash;
  state.state = "wander";
  team.send(0, "/io/state", state);
  team.send(0.1, "/io/transition",
            taken(program.transitions[0], {program.transitions[0], program.transitions[1]}));
  team.send(0.2, "/io/transition", taken(program.transitions[2]));
  team.send(0.3, "/io/program", program);
  return team.end();
}

}  // namespace galilean::monitor
