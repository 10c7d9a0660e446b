// SPDX-License-Identifier: BSD-3-Clause
#include "robot/telemetry/break_publisher.h"

#include "core/wire/topic_names.h"
#include "robot/log/log.h"
#include "robot/telemetry/break_words.h"
#include "robot/telemetry/team_stop.h"

namespace galilean::robot {
namespace {

constexpr Duration kReportEach = std::chrono::seconds(1);

}  // namespace

BreakPublisher::BreakPublisher(const TelemetrySource& source, const BreakDesk& desk)
    : robot_(source.robot),
      executive_(source.executive),
      desk_(desk),
      clock_(source.clock),
      wall_(source.clock),
      breaks_(source.participant, wire::robot_topic(source.robot, "breaks")),
      commands_(source.participant, wire::kCommandTopic) {}

void BreakPublisher::on_event(const Event& event) {
  if (event.kind != Event::Kind::kTransition) return;
  if (event.stopped_by == Hold::kStepEnd)
    log_info("stopped after the step that " + desk_.told().stepped_by + " ordered");
  if (event.stopped_by != Hold::kBreakPoint) return;
  if (const auto point = executive_.breaks().find(event.break_point))
    log_break(*point, event.number);
}

void BreakPublisher::log_break(const BreakPoint& point, std::uint64_t transition) {
  log_info("stopped at " + name_of(point) + ", set by " + point.author);
  if (point.kind != BreakKind::kStopTeam) return;
  if (!commands_.write(command_of({robot_, name_of(point), point.author}, transition)))
    log_error("the other robots could not be told to stop: DDS did not take the command");
}

void BreakPublisher::on_round(const Snapshot& newest) {
  const Shown shows{desk_.orders(), newest.standstill};
  if (shown_ == shows && clock_.now() < next_report_) return;
  if (!breaks_.write(compose(newest, desk_.told()))) return;
  shown_ = shows;
  next_report_ = clock_.now() + kReportEach;
}

msg::Breaks BreakPublisher::compose(const Snapshot& newest, const BreakDesk::Told& told) {
  wall_.refresh();
  msg::Breaks breaks;
  breaks.stamp = WallTime::now();
  breaks.robot = robot_;
  breaks.stepping = newest.standstill.hold == Hold::kStepping;
  breaks.answers = told.answers;
  tell_points(breaks);
  tell_stop(newest.standstill, told, breaks);
  tell_wait(newest, breaks);
  return breaks;
}

void BreakPublisher::tell_points(msg::Breaks& to) const {
  for (const BreakPoint& point : executive_.breaks().points()) {
    msg::BreakPoint& item = to.points.emplace_back();
    item.from_state = point.at.from_state;
    item.to_state = point.at.to_state;
    item.kind = on_wire(point.kind);
  }
}

void BreakPublisher::tell_stop(const Standstill& standstill, const BreakDesk::Told& told,
                               msg::Breaks& to) const {
  to.stopped = is_stop(standstill.hold);
  if (!to.stopped) return;
  if (standstill.hold == Hold::kTeam) {
    to.stopped_by = told.team_stop;
    to.author = told.team_stop_by;
    return;
  }
  to.stopped_at = standstill.stopped_at;
  to.stopped_by = "a step";
  to.author = told.stepped_by;
  if (standstill.hold != Hold::kBreakPoint) return;
  const auto point = executive_.breaks().find(standstill.break_point);
  to.stopped_by = point ? name_of(*point) : "a break point";
  to.author = point ? point->author : "";
}

void BreakPublisher::tell_wait(const Snapshot& newest, msg::Breaks& to) const {
  const LockWait& wait = newest.standstill.wait;
  if (wait.condition == Event::kNone) return;
  const auto program = executive_.description(newest.program);
  if (!program) return;
  const auto& state = program->program.states.at(newest.state);
  to.waits_at_from = state.name;
  to.waits_at_to = state.conditions.at(wait.condition).new_state;
  to.waits_since = wall_.stamp(wait.since);
}

}  // namespace galilean::robot
