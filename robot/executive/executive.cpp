// SPDX-License-Identifier: BSD-3-Clause
#include "robot/executive/executive.h"

#include <utility>

#include "core/device/frame_grabber.h"
#include "robot/executive/sequencer.h"
#include "robot/executive/swap.h"

namespace galilean::robot {
namespace {

/// Starts the fading of the initial values now, when the program takes over.
void start_fading(RunningProgram& program, Time now) noexcept {
  program.variables.for_each([now](auto& variable) { variable.reliability.stamp = now; });
}

DeviceHealth health_of(const Devices& devices) noexcept {
  return {devices.comm_port.healthy(), devices.motor_drive.healthy(),
          devices.frame_grabber.healthy()};
}

}  // namespace

Executive::Executive(const ExecutiveSetup& setup)
    : setup_(setup),
      port_(setup_.devices.comm_port),
      drive_(setup_.devices.motor_drive),
      devices_{port_, drive_, setup_.devices.frame_grabber},
      succession_(intake_) {
  tick_.period = setup_.tick_period;
}

Executive::~Executive() = default;

Result<ProgramId> Executive::load(bhdl::Program program, const ProbationRules& rules) {
  auto id =
      intake_.load(std::move(program), {setup_.components, devices_, Random(setup_.seed), rules});
  if (id && setup_.on_waiting) setup_.on_waiting();
  return id;
}

bool Executive::roll_back(ProgramId program, std::string_view reason) {
  if (!intake_.order_rollback({program, ShortText(reason)})) return false;
  if (setup_.on_waiting) setup_.on_waiting();
  return true;
}

void Executive::tick() {
  begin_tick();
  exchange_programs();
  sense();
  perceive();
  sequence();
  act();
  publish();
}

void Executive::begin_tick() noexcept {
  began_ = setup_.stopwatch.now();
  const Time now = setup_.clock.now();
  if (tick_.number > 0 && now - tick_.now >= 2 * tick_.period) ++overruns_;
  tick_.now = now;
  ++tick_.number;
  state_changed_ = false;
  exchanged_ = Event{};
}

void Executive::exchange_programs() noexcept {
  exchanging_.store(true);
  succession_.advance(tick_.now, health_,
                      [this](const Handover& handover) noexcept { install(handover); });
  exchanging_.store(false);
}

void Executive::install(const Handover& handover) noexcept {
  RunningProgram& program = *current_program();
  running_id_.store(succession_.running_id());
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
  note_transition(change);
}

void Executive::restore(const Situation& situation) {
  if (!current_program()) return;
  restore_variables(situation, *current_program(), setup_.clock.now());
  enter(successor_state(situation.state, *current_program()));
}

void Executive::enter(std::uint32_t state) noexcept {
  current_program()->state = state;
  current_program()->state_since = tick_.now;
  for (const std::uint32_t schema : current().perceptual_schemas) activate(schema);
  for (const std::uint32_t schema : current().motor_schemas) activate(schema);
}

void Executive::sense() noexcept {
  devices_.comm_port.sense(tick_.now);
  devices_.motor_drive.sense(tick_.now);
  devices_.frame_grabber.sense(tick_.now);
  health_ = health_of(devices_);
  odometry_.update(devices_, current_program(), tick_);
}

void Executive::perceive() noexcept {
  if (!current_program()) return;
  for (const std::uint32_t schema : current().perceptual_schemas) run(schema);
}

void Executive::sequence() noexcept {
  if (!current_program()) return;
  const auto condition = first_that_holds(current(), tick_.now);
  if (!condition) return;
  const RunningCondition& fired = current().conditions[*condition];
  Event change = event(Event::Kind::kTransition);
  change.condition = *condition;
  change.from_state = current_program()->state;
  change.tested = test_all(current(), tick_.now);
  fire(fired, tick_.now);
  enter(fired.new_state);
  note_transition(change);
}

void Executive::act() noexcept {
  drive_.begin(tick_.now, may_drive());
  if (current_program())
    for (const std::uint32_t schema : current().motor_schemas) run(schema);
  drive_.finish(state_changed_);
}

bool Executive::may_drive() const noexcept {
  const bool sees = health_.frame_grabber || !(program() && program()->devices.uses_camera);
  return program() && sees && health_.comm_port && health_.motor_drive && !held() && in_service();
}

void Executive::publish() noexcept {
  tick_time_ = setup_.stopwatch.now() - began_;
  if (exchanged_.program != 0) {
    exchanged_.tick_time = tick_time_;
    emit(exchanged_);
  }
  judge_probation();
  const TickView view{.tick = tick_,
                      .program = program(),
                      .devices = devices_,
                      .health = health_,
                      .pose = pose(),
                      .held = held(),
                      .out_of_service = !in_service(),
                      .in_probation = succession_.probation().active(),
                      .tick_time = tick_time_,
                      .overruns = overruns_,
                      .transitions = transitions_};
  for (TickObserver* observer : setup_.observers) observer->on_tick(view);
}

void Executive::judge_probation() noexcept {
  Probation& probation = succession_.probation();
  if (!probation.active()) return;
  probation.note_tick(health_, tick_time_ > tick_.period);
  if (!probation.passed(tick_.now)) return;
  probation.end();
  emit(event(Event::Kind::kConfirmed));
}

void Executive::activate(std::uint32_t schema) noexcept {
  if (!current_program()->schemas[schema].activate(tick_)) note_failure(schema);
}

void Executive::run(std::uint32_t schema) noexcept {
  if (!current_program()->schemas[schema].run(tick_)) note_failure(schema);
}

void Executive::note_failure(std::uint32_t schema) noexcept {
  Event failure = event(Event::Kind::kSchemaFailed);
  failure.schema = schema;
  failure.text = current_program()->schemas[schema].failure();
  succession_.probation().note_schema_failure(schema, failure.text);
  emit(failure);
}

void Executive::note_transition(Event change) noexcept {
  change.to_state = current_program()->state;
  change.number = ++transitions_;
  state_changed_ = true;
  succession_.probation().note_transition(tick_.now);
  emit(change);
}

Event Executive::event(Event::Kind kind) const noexcept {
  Event event;
  event.kind = kind;
  event.program = event.from_program = succession_.running_id();
  event.time = tick_.now;
  event.tick = tick_.number;
  return event;
}

void Executive::emit(const Event& event) noexcept {
  for (TickObserver* observer : setup_.observers) observer->on_event(event);
}

const RunningState& Executive::current() const noexcept {
  return program()->states[program()->state];
}

std::string_view Executive::state_name() const noexcept {
  return program() ? std::string_view(program()->state_name()) : std::string_view();
}

Duration Executive::time_in_state() const noexcept {
  return program() ? tick_.now - program()->state_since : Duration{};
}

void Executive::hash_into(StateHash& hash) const noexcept {
  hash.add(tick_.number);
  hash.add(state_name());
  add_pose(hash, pose());
  if (program()) add_variables(hash, *program(), tick_.now);
}

Pose2 Executive::pose() const noexcept {
  return odometry_.pose(program());
}

}  // namespace galilean::robot
