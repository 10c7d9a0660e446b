// SPDX-License-Identifier: BSD-3-Clause
#include "robot/executive/executive.h"

#include <utility>

#include "core/device/frame_grabber.h"

namespace galilean::robot {
namespace {

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
  if (setup_.admits)
    if (const auto admitted = setup_.admits(program); !admitted) return admitted.error();
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
  const Duration since_last_tick = tick_.number > 0 ? now - tick_.now : Duration{};
  if (since_last_tick >= 2 * tick_.period) ++overruns_;
  tick_.now = now;
  ++tick_.number;
  state_changed_ = false;
  exchanged_ = Event{};
  breaks_.refresh();
  watch_faults(since_last_tick);
  take_orders();
}

void Executive::take_orders() noexcept {
  const Hold hold = holding_.now();
  orders_ = {.hold = hold, .hold_changed = hold != hold_, .in_service = in_service()};
  hold_ = hold;
}

void Executive::enter(std::uint32_t state) noexcept {
  current_program()->state = state;
  current_program()->state_since = tick_.now;
  where_.store({succession_.running_id(), state});
  standstill_.wait = {};
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

void Executive::act() noexcept {
  drive_.begin(tick_.now, may_drive());
  if (current_program())
    for (const std::uint32_t schema : current().motor_schemas) run(schema);
  drive_.finish(state_changed_);
}

bool Executive::may_drive() const noexcept {
  const bool sees = health_.frame_grabber || !(program() && program()->devices.uses_camera);
  return program() && sees && health_.comm_port && health_.motor_drive && lets_drive(hold_) &&
         orders_.in_service;
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
                      .speed_mps = odometry_.speed_mps(),
                      .turn_rate_radps = odometry_.turn_rate_radps(),
                      .standstill = standstill(),
                      .fault = hold_ == Hold::kFault ? faults_.report() : FaultReport{},
                      .out_of_service = !orders_.in_service,
                      .in_probation = succession_.probation().active(),
                      .tick_time = tick_time_,
                      .overruns = overruns_,
                      .transitions = transitions_,
                      .orders = orders_,
                      .break_table = breaks_.table_number(),
                      .motion = drive_.orders(),
                      .gripper = port_.gripper_order(),
                      .executive = this};
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
