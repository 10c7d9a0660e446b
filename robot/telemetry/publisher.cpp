// SPDX-License-Identifier: BSD-3-Clause
#include "robot/telemetry/publisher.h"

#include <algorithm>
#include <iterator>
#include <thread>
#include <utility>

#include "core/state_change.h"
#include "robot/log/log.h"
#include "robot/telemetry/robot_writers.h"
#include "robot/telemetry/words.h"

namespace galilean::robot {
namespace {

/// The longest wait of an event, because the control loop does not wake this thread.
constexpr Duration kSnapshotPause = std::chrono::milliseconds(3);
constexpr Duration kReport = std::chrono::milliseconds(100);
constexpr Duration kDiagnosis = std::chrono::seconds(1);
constexpr Duration kStandstill = std::chrono::seconds(2);

bool contains(const std::vector<Problem>& list, const Problem& item) {
  return std::ranges::find(list, item) != list.end();
}

/// Writes a message. One that the network does not take in time is lost, and the next one says the
/// same or more.
template <class M>
void write(wire::Writer<M>& writer, const M& message) {
  static_cast<void>(writer.write(message));
}

/// Returns "office_cleanup.bhdl (0123abcd)".
std::string named(const bhdl::Program& program) {
  return program.name + " (" + program.hash.substr(0, 8) + ")";
}

/// This failure is logged, because the thread that publishes the other threads' problems may not be
/// able to publish its own.
void log_failure(const std::string& failure) {
  if (failure.empty())
    log_info("telemetry works again");
  else
    log_error("telemetry failed (" + failure + ") and is tried again");
}

}  // namespace

Publisher::Publisher(const TelemetrySource& source, LogQueue& log, const ThreadProblems& threads,
                     Listener listener)
    : source_(source),
      log_(log),
      threads_(threads),
      listener_(std::move(listener)),
      compose_(source.robot, source.clock),
      writers_(std::make_shared<RobotWriters>(source.participant, source.robot)) {
  write(writers_->catalog, compose_.catalog(source_.catalog));
  worker_ = Worker(
      [this](const std::stop_token& stop) {
        step();
        std::this_thread::sleep_for(kSnapshotPause);
        if (stop.stop_requested()) step();
      },
      log_failure);
}

void Publisher::step() {
  compose_.refresh_time();
  source_.executive.collect();
  bool anything_happened = false;
  while (const auto event = source_.tap.next_event()) {
    tell(*event);
    anything_happened = true;
  }
  if (source_.tap.take()) tell_sightings();
  if (anything_happened) tell_what_is();
  listener_.round(source_.tap.newest());
  if (source_.clock.now() >= next_report_) tell_regularly();
  for (const auto& line : log_.take()) {
    msg::Log message;
    message.stamp = wire::ros_time(line.time_ns);
    message.level = line.level;
    message.name = source_.robot;
    message.msg = line.text;
    write(writers_->log, message);
  }
}

const Description* Publisher::describe(ProgramId id) {
  if (!described_ || described_->id != id) described_ = source_.executive.description(id);
  return described_.get();
}

void Publisher::tell(const Event& event) {
  if (event.kind == Event::Kind::kTransition)
    tell_transition(event);
  else if (event.kind != Event::Kind::kConfirmed && event.kind != Event::Kind::kSchemaFailed)
    tell_program(event.program);
  if (event.kind == Event::Kind::kRolledBack) log_rollback(event);
  listener_.event(event);
}

void Publisher::log_rollback(const Event& event) {
  const auto failed = source_.executive.description(event.from_program);
  const auto runs = source_.executive.description(event.program);
  if (failed && runs)
    log_warning("program " + named(failed->program) + " was rolled back to " +
                named(runs->program) + ": " + fault_of(event, *failed));
}

void Publisher::tell_transition(const Event& event) {
  const auto from = source_.executive.description(event.from_program);
  const auto to = source_.executive.description(event.program);
  if (!from || !to) return;
  const msg::Transition transition = compose_.transition(event, *from, *to);
  log_info(change_words(transition.from_state, transition.to_state) + " (" + transition.cause +
           ")");
  write(writers_->transition, transition);
}

void Publisher::tell_program(ProgramId id) {
  if (const Description* program = describe(id))
    write(writers_->program, compose_.program(*program));
}

void Publisher::tell_sightings() {
  const Snapshot& snapshot = source_.tap.newest();
  if (snapshot.frame == last_frame_) return;
  last_frame_ = snapshot.frame;
  if (const Description* program = describe(snapshot.program))
    write(writers_->sightings, compose_.sightings(snapshot, *program));
}

std::vector<Problem> Publisher::problems() const {
  const Snapshot& snapshot = source_.tap.newest();
  auto problems = problems_of(snapshot, described_.get(), source_.devices);
  if (source_.clock.now() - snapshot.now > kStandstill)
    problems.push_back({"executive", "The control loop stands still."});
  std::ranges::move(threads_.all(), std::back_inserter(problems));
  return problems;
}

void Publisher::tell_state() {
  const Snapshot& snapshot = source_.tap.newest();
  write(writers_->state, compose_.state(snapshot, describe(snapshot.program), problems_));
}

void Publisher::tell_what_is() {
  tell_state();
  const Snapshot& snapshot = source_.tap.newest();
  if (const Description* program = describe(snapshot.program))
    write(writers_->variables, compose_.variables(snapshot, *program));
}

void Publisher::tell_regularly() {
  const Time now = source_.clock.now();
  next_report_ = std::max(next_report_ + kReport, now);
  const Snapshot& snapshot = source_.tap.newest();
  if (snapshot.tick == 0) return;
  const Description* program = describe(snapshot.program);
  auto found = problems();
  log_changes(found);
  problems_ = std::move(found);
  tell_what_is();
  source_.tap.restart_longest();
  write(writers_->odometry, compose_.odometry(snapshot));
  write(writers_->transform, compose_.transform(snapshot));
  if (program) write(writers_->forces, compose_.forces(snapshot, *program));
  if (now < next_diagnosis_) return;
  next_diagnosis_ = now + kDiagnosis;
  write(writers_->diagnostics, compose_.diagnostics(snapshot, problems_));
}

void Publisher::log_changes(const std::vector<Problem>& problems) {
  for (const Problem& problem : problems)
    if (!contains(problems_, problem)) log_warning(problem.text());
  for (const Problem& problem : problems_)
    if (!contains(problems, problem)) log_info("This problem is over: " + problem.text());
}

}  // namespace galilean::robot
