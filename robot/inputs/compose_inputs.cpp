// SPDX-License-Identifier: BSD-3-Clause
#include "robot/inputs/compose_inputs.h"

#include "robot/inputs/input_digests.h"

namespace galilean::robot {
namespace {

std::int64_t nanoseconds(Time time) noexcept {
  return time.time_since_epoch().count();
}

msg::GivenProgram given(const Description& description) {
  msg::GivenProgram made;
  made.id = description.id;
  made.hash = description.program.hash;
  for (const auto& file : description.program.files) made.files.push_back({file.path, file.text});
  made.probation_ns = description.probation.length.count();
  made.most_transitions_per_s =
      static_cast<std::uint32_t>(description.probation.most_transitions_per_s);
  return made;
}

msg::BreakTable table_on_wire(const BreakTable& table) {
  msg::BreakTable made;
  made.number = table.number;
  for (const BreakPoint& point : table.points) {
    msg::BreakPoint& on_wire = made.points.emplace_back();
    on_wire.from_state = point.at.from_state;
    on_wire.to_state = point.at.to_state;
    on_wire.kind = static_cast<std::uint8_t>(static_cast<unsigned>(point.kind) + 1);
    made.point_numbers.push_back(point.number);
  }
  for (const LockPass& pass : table.passes)
    made.passes.push_back({pass.at.from_state, pass.at.to_state, pass.number});
  return made;
}

void copy_orders(const TickRecord& record, msg::TickInputs& to) {
  to.tick_period_ns = record.period.count();
  to.tick = record.tick;
  to.now_ns = nanoseconds(record.now);
  to.tick_time_ns = record.tick_time.count();
  to.hold = static_cast<std::uint8_t>(record.orders.hold);
  to.hold_changed = record.orders.hold_changed;
  to.in_service = record.orders.in_service;
  to.rolled_back = record.rolled_back;
  to.rollback_reason = record.reason.view();
}

void copy_board(const TickRecord& record, msg::TickInputs& to) {
  to.comm_port = record.health.comm_port;
  to.motor_drive = record.health.motor_drive;
  to.frame_grabber = record.health.frame_grabber;
  to.received_ns = nanoseconds(record.board.received);
  to.bumpers = record.board.bumpers;
  to.beam_broken = record.board.beam_broken;
  to.gripper_closed = record.board.gripper_closed;
  to.left_travel_m = record.board.left_travel_m;
  to.right_travel_m = record.board.right_travel_m;
  to.left_speed_mps = record.board.left_speed_mps;
  to.right_speed_mps = record.board.right_speed_mps;
  to.epoch = record.board.epoch;
}

}  // namespace

msg::TickOutcome outcome_on_wire(const TickOutcome& outcome, std::string state) {
  msg::TickOutcome made;
  made.program = outcome.program;
  made.state = std::move(state);
  made.transitions = outcome.transitions;
  made.fired = outcome.fired == Event::kNone ? -1 : static_cast<std::int32_t>(outcome.fired);
  made.motion_orders = outcome.motion.count;
  made.stops = outcome.motion.stop;
  made.speed_mps = outcome.motion.last.speed_mps;
  made.turn_rate_radps = outcome.motion.last.turn_rate_radps;
  made.distance_limit_m = outcome.motion.last.distance_limit_m;
  made.angle_limit_rad = outcome.motion.last.angle_limit_rad;
  if (outcome.gripper) made.gripper = *outcome.gripper == GripperCommand::kOpen ? 1 : 2;
  made.rest = outcome.rest;
  made.variables.assign(outcome.variables.begin(), outcome.variables.end());
  return made;
}

bool InputsComposer::take(InputsTap& tap, msg::TickInputs& to) {
  TickRecord record;
  if (!tap.take(record)) return false;
  to = {};
  to.robot = source_.robot;
  to.lost = tap.lost();
  to.seed = source_.seed;
  copy_orders(record, to);
  add_breaks(record, to);
  add_program(record, to);
  copy_board(record, to);
  add_picture(record, tap, to);
  to.orders_digest = orders_digest(to);
  to.board_digest = board_digest(to);
  to.picture_digest = picture_digest(to, pixels_digest_);
  to.outcome = outcome_on_wire(record.outcome, state_name(record.outcome));
  add_memory(record, tap, to);
  return true;
}

/// Without the program's text or the table the memory is of no use, and left out.
void InputsComposer::add_memory(const TickRecord& record, const InputsTap& tap,
                                msg::TickInputs& to) {
  if (record.memory_words == 0 || !program_) return;
  const auto table = record.break_table == 0 ? std::optional<BreakTable>(std::in_place)
                                             : source_.break_table(record.break_table);
  if (!table) return;
  msg::ExecutiveMemory& memory = to.memory.emplace_back();
  memory.program = given(*program_);
  memory.break_table = table_on_wire(*table);
  memory.has_predecessor = record.has_predecessor;
  memory.words = static_cast<std::uint32_t>(tap.memory().size());
  const auto bytes = std::as_bytes(tap.memory());
  packer_.pack_bytes({reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()},
                     memory.packed);
  memory.digest = memory_digest(memory, tap.memory());
}

void InputsComposer::add_breaks(const TickRecord& record, msg::TickInputs& to) {
  if (record.break_table == told_table_) return;
  told_table_ = record.break_table;
  if (const auto table = source_.break_table(record.break_table))
    to.break_table.push_back(table_on_wire(*table));
}

void InputsComposer::add_program(const TickRecord& record, msg::TickInputs& to) {
  if (record.taken_over == 0) return;
  program_ = source_.description(record.taken_over);
  if (program_) to.program.push_back(given(*program_));
}

void InputsComposer::add_picture(const TickRecord& record, const InputsTap& tap,
                                 msg::TickInputs& to) {
  to.frame = record.frame;
  to.captured_ns = nanoseconds(record.captured);
  if (!record.has_picture) return;
  packer_.pack(tap.picture().rgb, to.picture);
  pixels_digest_ = pixels_digest(tap.picture().rgb);
}

std::string InputsComposer::state_name(const TickOutcome& outcome) {
  if (outcome.program == 0) return {};
  if (!program_ || program_->id != outcome.program) program_ = source_.description(outcome.program);
  return program_ ? program_->program.states.at(outcome.state).name : std::string();
}

}  // namespace galilean::robot
