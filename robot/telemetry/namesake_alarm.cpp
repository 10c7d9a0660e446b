// SPDX-License-Identifier: BSD-3-Clause
#include "robot/telemetry/namesake_alarm.h"

#include <string>

#include "core/wire/topic_names.h"

namespace galilean::robot {
namespace {

/// As often as robots tell their state: of two that start at the same moment, neither gets far.
constexpr Duration kLookEach = std::chrono::milliseconds(100);

}  // namespace

NamesakeAlarm::NamesakeAlarm(const TelemetrySource& source, ThreadProblems& problems)
    : source_(source),
      problems_(problems),
      watch_(source.participant, source.robot),
      joined_(source.participant, {wire::robot_topic(source.robot, "state"), wire::kCommandTopic}),
      began_(source.clock.now()) {}

void NamesakeAlarm::on_round() {
  const Time now = source_.clock.now();
  if (now >= next_look_) look(now);
  if (namesake_ == Namesake::kObeys && is_second_ && !source_.executive.held())
    source_.executive.hold_after(FaultCause::kNamesake);
}

void NamesakeAlarm::look(Time now) {
  next_look_ = now + kLookEach;
  const Namesake joined = judge_joined(now);
  const Namesake namesake = watch_.count(now) > 1 ? Namesake::kObeys : joined;
  if (namesake == namesake_) return;
  namesake_ = namesake;
  is_second_ = is_second_ || (namesake == Namesake::kObeys && now - began_ < kNewcomer);
  problems_.note("name", sentence());
}

/// Judges those that have joined under this name, whether or not they can be heard.
NamesakeAlarm::Namesake NamesakeAlarm::judge_joined(Time now) {
  if (joined_.count() == 0) {
    joined_since_.reset();
    return now < told_until_ ? Namesake::kWasStarted : Namesake::kNone;
  }
  if (!joined_since_) joined_since_ = now;
  const bool may_end = now - *joined_since_ <= kEndsWithin;
  told_until_ = may_end ? now + kToldFor : now;
  return may_end ? Namesake::kWasStarted : Namesake::kObeys;
}

std::string NamesakeAlarm::sentence() const {
  const std::string domain = std::to_string(source_.participant.domain());
  switch (namesake_) {
    case Namesake::kNone:
      break;
    case Namesake::kWasStarted:
      return "Another robot named " + source_.robot + " was started in DDS domain " + domain +
             ", and must not be: it ends by itself; start it with another --name.";
    case Namesake::kObeys:
      return "Another robot named " + source_.robot + " is in DDS domain " + domain +
             ": both obey every order and take every push; end one of them, or start it again with "
             "another --name.";
  }
  return "";
}

}  // namespace galilean::robot
