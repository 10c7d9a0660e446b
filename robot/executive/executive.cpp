#include "robot/executive/executive.h"

#include <utility>

#include "core/device/frame_grabber.h"
#include "robot/executive/builder.h"
#include "robot/executive/sequencer.h"
#include "robot/executive/swap.h"

namespace galilean::robot {
namespace {

constexpr std::size_t kDescriptionsKept = 16;

ProgramId id_of(const RunningProgram* program) noexcept {
  return program ? program->description->id : 0;
}

/// What the text says of a variable holds from the moment when the program takes over.
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
      devices_{port_, drive_, setup_.devices.frame_grabber} {
  tick_.period = setup_.tick_period;
}

Executive::~Executive() = default;

Result<ProgramId> Executive::load(bhdl::Program program, const ProbationRules& rules) {
  const std::lock_guard lock(shelf_mutex_);
  exchange_.collect();
  if (exchange_.waiting()) return Error{"another program still waits for its first tick"};
  auto built = build(std::move(program), last_id_ + 1,
                     {setup_.components, devices_, Random(setup_.seed), rules});
  if (!built) return built.error();
  shelf_[++last_id_] = built.value()->description;
  tidy_shelf();
  exchange_.offer(std::move(built).value());
  if (setup_.on_waiting) setup_.on_waiting();
  return last_id_;
}

bool Executive::roll_back(ProgramId program, std::string_view reason) {
  const std::lock_guard lock(shelf_mutex_);
  if (!orders_.push({program, ShortText(reason)})) return false;
  if (setup_.on_waiting) setup_.on_waiting();
  return true;
}

/// What a program that still lives holds stays, however old it is.
void Executive::tidy_shelf() {
  for (auto each = shelf_.begin(); shelf_.size() > kDescriptionsKept && each != shelf_.end();)
    each = each->second.use_count() == 1 ? shelf_.erase(each) : std::next(each);
}

void Executive::collect() {
  const std::lock_guard lock(shelf_mutex_);
  exchange_.collect();
}

std::shared_ptr<const Description> Executive::description(ProgramId id) const {
  const std::lock_guard lock(shelf_mutex_);
  const auto found = shelf_.find(id);
  return found == shelf_.end() ? nullptr : found->second;
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
  if (const Verdict verdict = judgement(); verdict.fault != Fault::kNone)
    roll_back(verdict);
  else if (auto next = exchange_.take())
    take_over(std::move(next));
}

/// What is held against the running program, where another one can take its place.
Verdict Executive::judgement() noexcept {
  Verdict verdict = probation_.failed() ? probation_.verdict() : Verdict{};
  while (const auto order = orders_.pop())
    if (verdict.fault == Fault::kNone && order->program == id_of(running_.get()))
      verdict = {.fault = Fault::kOrdered, .reason = order->reason};
  return last_good_ ? verdict : Verdict{};
}

void Executive::take_over(std::unique_ptr<RunningProgram> next) noexcept {
  start_fading(*next, tick_.now);
  auto replaced = std::exchange(running_, std::move(next));
  exchanged_ = event(replaced ? Event::Kind::kSwapped : Event::Kind::kStarted);
  exchanged_.from_program = id_of(replaced.get());
  const bool replaced_is_proven = !probation_.active();
  if (replaced) probation_.begin(tick_.now, running_->description->probation, health_);
  install(replaced.get(), Event::Cause::kSwap);
  if (!replaced) return;
  retire(std::move(unproven_));
  std::swap(replaced_is_proven ? last_good_ : unproven_, replaced);
  retire(std::move(replaced));
}

/// The operator who takes a program off wants what ran before it; a program that failed tells that
/// nothing unproven is to be trusted.
std::unique_ptr<RunningProgram> Executive::predecessor(Fault fault) noexcept {
  if (fault == Fault::kOrdered && unproven_) return std::move(unproven_);
  retire(std::move(unproven_));
  return std::move(last_good_);
}

void Executive::retire(std::unique_ptr<RunningProgram> program) noexcept {
  if (program) exchange_.retire(std::move(program));
}

void Executive::roll_back(const Verdict& verdict) noexcept {
  auto replaced = std::exchange(running_, predecessor(verdict.fault));
  exchanged_ = event(Event::Kind::kRolledBack);
  exchanged_.from_program = id_of(replaced.get());
  exchanged_.fault = verdict.fault;
  exchanged_.schema = verdict.schema;
  exchanged_.text = verdict.reason;
  probation_.end();
  exchanged_.in_probation = last_good_ != nullptr;
  if (last_good_) probation_.begin(tick_.now, running_->description->probation, health_);
  install(replaced.get(), Event::Cause::kRollback);
  retire(std::move(replaced));
}

void Executive::install(RunningProgram* replaced, Event::Cause cause) noexcept {
  running_id_.store(id_of(running_.get()));
  drive_.set_timeout(from_seconds(running_->devices.motor_drive.timeout_s));
  if (setup_.tuner) setup_.tuner->tune(running_->devices);
  if (!replaced) return enter(running_->start_state);
  carry_over(*replaced, *running_, tick_.now);
  const std::uint32_t state = successor_state(*replaced, *running_);
  const bool same = running_->text().states[state].name == replaced->state_name();
  enter(state);
  if (same) {
    running_->state_since = replaced->state_since;
    return;
  }
  Event change = event(Event::Kind::kTransition);
  change.cause = cause;
  change.from_program = id_of(replaced);
  change.from_state = replaced->state;
  change.fault = exchanged_.fault;
  change.schema = exchanged_.schema;
  change.text = exchanged_.text;
  note_transition(change);
}

void Executive::restore(const Situation& situation) {
  if (!running_) return;
  restore_variables(situation, *running_, setup_.clock.now());
  enter(successor_state(situation.state, *running_));
}

void Executive::enter(std::uint32_t state) noexcept {
  running_->state = state;
  running_->state_since = tick_.now;
  for (const std::uint32_t schema : current().perceptual_schemas) activate(schema);
  for (const std::uint32_t schema : current().motor_schemas) activate(schema);
}

void Executive::sense() noexcept {
  devices_.comm_port.sense(tick_.now);
  devices_.motor_drive.sense(tick_.now);
  devices_.frame_grabber.sense(tick_.now);
  health_ = health_of(devices_);
  odometry_.update(devices_, running_.get(), tick_);
}

void Executive::perceive() noexcept {
  if (!running_) return;
  for (const std::uint32_t schema : current().perceptual_schemas) run(schema);
}

void Executive::sequence() noexcept {
  if (!running_) return;
  const auto condition = first_that_holds(current(), tick_.now);
  if (!condition) return;
  const RunningCondition& fired = current().conditions[*condition];
  Event change = event(Event::Kind::kTransition);
  change.condition = *condition;
  change.from_state = running_->state;
  change.tested = test_all(current(), tick_.now);
  fire(fired, tick_.now);
  enter(fired.new_state);
  note_transition(change);
}

void Executive::act() noexcept {
  drive_.begin(tick_.now, may_drive());
  if (running_)
    for (const std::uint32_t schema : current().motor_schemas) run(schema);
  drive_.finish(state_changed_);
}

bool Executive::may_drive() const noexcept {
  const bool sees = health_.frame_grabber || !(running_ && running_->devices.uses_camera);
  return running_ && sees && health_.comm_port && health_.motor_drive && !held() && in_service();
}

void Executive::publish() noexcept {
  tick_time_ = setup_.stopwatch.now() - began_;
  if (exchanged_.program != 0) {
    exchanged_.tick_time = tick_time_;
    emit(exchanged_);
  }
  judge_probation();
  const TickView view{.tick = tick_,
                      .program = running_.get(),
                      .devices = devices_,
                      .health = health_,
                      .pose = pose(),
                      .held = held(),
                      .out_of_service = !in_service(),
                      .in_probation = probation_.active(),
                      .tick_time = tick_time_,
                      .overruns = overruns_,
                      .transitions = transitions_};
  for (TickObserver* observer : setup_.observers) observer->on_tick(view);
}

void Executive::judge_probation() noexcept {
  if (!probation_.active()) return;
  probation_.note_tick(health_, tick_time_ > tick_.period);
  if (!probation_.passed(tick_.now)) return;
  probation_.end();
  emit(event(Event::Kind::kConfirmed));
}

void Executive::activate(std::uint32_t schema) noexcept {
  if (!running_->schemas[schema].activate(tick_)) note_failure(schema);
}

void Executive::run(std::uint32_t schema) noexcept {
  if (!running_->schemas[schema].run(tick_)) note_failure(schema);
}

void Executive::note_failure(std::uint32_t schema) noexcept {
  Event failure = event(Event::Kind::kSchemaFailed);
  failure.schema = schema;
  failure.text = running_->schemas[schema].failure();
  probation_.note_schema_failure(schema, failure.text);
  emit(failure);
}

void Executive::note_transition(Event change) noexcept {
  change.to_state = running_->state;
  change.number = ++transitions_;
  state_changed_ = true;
  probation_.note_transition(tick_.now);
  emit(change);
}

Event Executive::event(Event::Kind kind) const noexcept {
  Event event;
  event.kind = kind;
  event.program = event.from_program = id_of(running_.get());
  event.time = tick_.now;
  event.tick = tick_.number;
  return event;
}

void Executive::emit(const Event& event) noexcept {
  for (TickObserver* observer : setup_.observers) observer->on_event(event);
}

const RunningState& Executive::current() const noexcept {
  return running_->states[running_->state];
}

std::string_view Executive::state_name() const noexcept {
  return running_ ? std::string_view(running_->state_name()) : std::string_view();
}

Duration Executive::time_in_state() const noexcept {
  return running_ ? tick_.now - running_->state_since : Duration{};
}

Pose2 Executive::pose() const noexcept {
  return odometry_.pose(running_.get());
}

}  // namespace galilean::robot
