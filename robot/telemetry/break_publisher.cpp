// SPDX-License-Identifier: BSD-3-Clause
#include "robot/telemetry/break_publisher.h"

#include "core/wire/topic_names.h"
#include "robot/log/log.h"
#include "robot/telemetry/break_words.h"

namespace galilean::robot {
namespace {

namespace stoppers = msg::Breaks_Constants;

constexpr Duration kReportEach = std::chrono::seconds(1);

/// Returns what stopped the robot as a value of msg::Breaks_Constants.
std::uint8_t stopper_on_wire(Hold hold) noexcept {
  switch (hold) {
    case Hold::kBreakPoint:
      return stoppers::BREAK_POINT;
    case Hold::kStepEnd:
      return stoppers::STEP;
    case Hold::kTeam:
      return stoppers::TEAM;
    case Hold::kNone:
    case Hold::kStepping:
    case Hold::kOperator:
    case Hold::kFault:
      break;
  }
  return stoppers::NOTHING;
}

}  // namespace

BreakPublisher::BreakPublisher(const TelemetrySource& source, const BreakDesk& desk)
    : robot_(source.robot),
      executive_(source.executive),
      desk_(desk),
      clock_(source.clock),
      wall_(source.clock),
      breaks_(source.participant, wire::robot_topic(source.robot, "breaks")),
      team_stops_(source.participant, wire::kTeamStopTopic) {}

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
  if (!team_stops_.write(team_stop_at(point, transition)))
    log_error("the other robots could not be told to stop: DDS did not take the command");
}

msg::TeamStop BreakPublisher::team_stop_at(const BreakPoint& point,
                                           std::uint64_t transition) const {
  return {.stamp = WallTime::now(),
          .robot = robot_,
          .targets = {},
          .transition = transition,
          .break_point = on_wire(point),
          .author = point.author};
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
  for (const BreakPoint& point : executive_.breaks().points()) to.points.push_back(on_wire(point));
}

void BreakPublisher::tell_stop(const Standstill& standstill, const BreakDesk::Told& told,
                               msg::Breaks& to) const {
  to.stopped = is_stop(standstill.hold);
  to.stopped_by = stopper_on_wire(standstill.hold);
  if (!to.stopped) return;
  if (standstill.hold == Hold::kTeam) {
    to.break_robot = told.team_stop.robot;
    to.break_point = told.team_stop.break_point;
    to.author = told.team_stop.author;
    return;
  }
  to.stopped_at = standstill.stopped_at;
  to.author = told.stepped_by;
  if (standstill.hold != Hold::kBreakPoint) return;
  const auto point = executive_.breaks().find(standstill.break_point).value_or(BreakPoint{});
  to.break_robot = robot_;
  to.break_point = on_wire(point);
  to.author = point.author;
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
