// SPDX-License-Identifier: BSD-3-Clause
#include "robot/rerun/recorded_robot.h"

#include <algorithm>

namespace galilean::robot {
namespace {

Time time_of(std::int64_t nanoseconds) noexcept {
  return Time{Duration{nanoseconds}};
}

BreakTable table_of(const msg::BreakTable& recorded) {
  BreakTable table;
  table.number = recorded.number;
  for (std::size_t i = 0; i < recorded.points.size(); ++i) {
    const auto& point = recorded.points[i];
    const auto kind = static_cast<BreakKind>(std::max(point.kind, std::uint8_t{1}) - 1);
    table.points.push_back(
        {.at = {point.from_state, point.to_state},
         .kind = kind,
         .number = i < recorded.point_numbers.size() ? recorded.point_numbers[i] : 0});
  }
  for (const auto& pass : recorded.passes)
    table.passes.push_back({{pass.from_state, pass.to_state}, pass.number});
  return table;
}

/// Stops at break points and ends of steps are the executive's own.
void apply(Hold hold, Executive& executive) {
  switch (hold) {
    case Hold::kNone:
      return executive.resume();
    case Hold::kOperator:
      return executive.hold();
    case Hold::kStepping:
      executive.resume();
      return static_cast<void>(executive.step());
    case Hold::kTeam:
      executive.resume();
      return static_cast<void>(executive.stop_with_team());
    case Hold::kFault:
      executive.resume();
      return executive.hold_after(FaultCause::kNone);
    case Hold::kBreakPoint:
    case Hold::kStepEnd:
      return;
  }
}

}  // namespace

RecordedRobot::RecordedRobot(const Registry& components, const msg::TickInputs& first)
    : executive_({.components = components,
                  .devices = devices_.devices(),
                  .clock = clock_,
                  .stopwatch = stopwatch_,
                  .seed = first.seed,
                  .tick_period = Duration(first.tick_period_ns),
                  .tuner = &devices_,
                  .observers = {&watch_}}) {}

Result<void> RecordedRobot::adopt(bhdl::Program program, const msg::TickInputs& inputs,
                                  std::span<const std::uint8_t> rgb,
                                  std::span<const std::uint64_t> memory) {
  if (auto loaded = load(std::move(program), inputs.memory.front().program); !loaded) return loaded;
  executive_.breaks().replay(table_of(inputs.memory.front().break_table));
  inputs.in_service ? executive_.commission() : executive_.decommission();
  give(inputs, rgb);
  if (executive_.adopt(memory)) return {};
  return Error{"what the executive remembered does not fit its program"};
}

Result<void> RecordedRobot::load(bhdl::Program program, const msg::GivenProgram& given) {
  const int most = static_cast<int>(
      std::clamp<std::uint32_t>(given.most_transitions_per_s, 1, ProbationRules::kMostCounted));
  const auto id = executive_.load(
      std::move(program), {.length = Duration(given.probation_ns), .most_transitions_per_s = most});
  if (!id) return id.error();
  recorded_numbers_[id.value()] = given.id;
  return {};
}

/// Returns 0 if it is none of those that were loaded here.
ProgramId RecordedRobot::own_number(ProgramId recorded) const noexcept {
  ProgramId newest = 0;
  for (const auto& [own, number] : recorded_numbers_)
    if (number == recorded) newest = own;
  return newest;
}

Result<void> RecordedRobot::tick(const msg::TickInputs& inputs, std::span<const std::uint8_t> rgb) {
  if (inputs.rolled_back != 0 &&
      !executive_.roll_back(own_number(inputs.rolled_back), inputs.rollback_reason))
    return Error{"the order to go back to the program before was not taken"};
  obey(inputs);
  give(inputs, rgb);
  executive_.tick();
  executive_.collect();
  const auto number = recorded_numbers_.find(watch_.outcome.program);
  if (number != recorded_numbers_.end()) watch_.outcome.program = number->second;
  return {};
}

void RecordedRobot::obey(const msg::TickInputs& inputs) {
  for (const auto& table : inputs.break_table) executive_.breaks().replay(table_of(table));
  if (inputs.hold_changed) apply(static_cast<Hold>(inputs.hold), executive_);
  inputs.in_service ? executive_.commission() : executive_.decommission();
}

void RecordedRobot::give(const msg::TickInputs& inputs, std::span<const std::uint8_t> rgb) {
  clock_.advance(time_of(inputs.now_ns) - clock_.now());
  stopwatch_.next_takes(Duration(inputs.tick_time_ns));
  devices_.port.give({.received = time_of(inputs.received_ns),
                      .bumpers = inputs.bumpers,
                      .beam_broken = inputs.beam_broken,
                      .gripper_closed = inputs.gripper_closed,
                      .left_travel_m = inputs.left_travel_m,
                      .right_travel_m = inputs.right_travel_m,
                      .left_speed_mps = inputs.left_speed_mps,
                      .right_speed_mps = inputs.right_speed_mps,
                      .epoch = inputs.epoch},
                     inputs.comm_port);
  devices_.drive.give(inputs.motor_drive);
  devices_.camera.give(inputs.frame_grabber);
  Frame& picture = devices_.camera.picture();
  picture.number = inputs.frame;
  picture.captured = time_of(inputs.captured_ns);
  if (rgb.size() == picture.rgb.size()) std::ranges::copy(rgb, picture.rgb.begin());
}

std::uint32_t RecordedRobot::perceived_in() const noexcept {
  return watch_.outcome.fired == Event::kNone ? watch_.outcome.state : watch_.left_state;
}

void RecordedRobot::Watch::on_event(const Event& event) noexcept {
  if (event.kind != Event::Kind::kTransition || event.cause != Event::Cause::kCondition) return;
  fired = event.condition;
  left_state = event.from_state;
}

void RecordedRobot::Watch::on_tick(const TickView& view) noexcept {
  digests.take(view, outcome);
  outcome.fired = fired;
  fired = Event::kNone;
}

}  // namespace galilean::robot
