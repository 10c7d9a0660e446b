// SPDX-License-Identifier: BSD-3-Clause
// How an executive goes from one program to another.
#include "robot/executive/executive.h"
#include "robot/executive/swap.h"

namespace galilean::robot {
namespace {

/// Starts the fading of the initial values now, when the program takes over.
void start_fading(RunningProgram& program, Time now) noexcept {
  program.variables.for_each([now](auto& variable) { variable.reliability.stamp = now; });
}

}  // namespace

void Executive::exchange_programs() noexcept {
  exchanging_.store(true);
  succession_.advance(tick_.now, health_,
                      [this](const Handover& handover) noexcept { install(handover); });
  exchanging_.store(false);
}

void Executive::install(const Handover& handover) noexcept {
  RunningProgram& program = *current_program();
  exchanged_ = event(handover.kind);
  exchanged_.from_program = handover.replaced ? handover.replaced->description->id : 0;
  exchanged_.fault = handover.verdict.fault;
  exchanged_.schema = handover.verdict.schema;
  exchanged_.text = handover.verdict.reason;
  exchanged_.in_probation =
      handover.kind == Event::Kind::kRolledBack && succession_.probation().active();

  if (handover.kind != Event::Kind::kRolledBack) start_fading(program, tick_.now);
  drive_.set_timeout(from_seconds(program.devices.motor_drive.timeout_s));
  if (setup_.tuner) setup_.tuner->tune(program.devices);
  if (!handover.replaced) return enter(program.start_state);
  carry_over(*handover.replaced, program, tick_.now);
  go_on_from(*handover.replaced);
}

/// Enters the state that `replaced` was in if the program has it, and its successor otherwise.
void Executive::go_on_from(const RunningProgram& replaced) noexcept {
  RunningProgram& program = *current_program();
  const std::uint32_t state = successor_state(replaced, program);
  const bool same = program.text().states[state].name == replaced.state_name();
  enter(state);
  if (same) {
    program.state_since = replaced.state_since;
    return;
  }
  Event change = exchanged_;
  change.kind = Event::Kind::kTransition;
  change.cause =
      exchanged_.kind == Event::Kind::kRolledBack ? Event::Cause::kRollback : Event::Cause::kSwap;
  change.in_probation = false;
  change.from_state = replaced.state;
  note_transition(change, replaced.state_name());
}

void Executive::restore(const Situation& situation) {
  if (!current_program()) return;
  restore_variables(situation, *current_program(), setup_.clock.now());
  enter(successor_state(situation.state, *current_program()));
}

}  // namespace galilean::robot
