// SPDX-License-Identifier: BSD-3-Clause
#include "robot/telemetry/namesake_alarm.h"

namespace galilean::robot {
namespace {

/// As often as robots tell their state: of two that start at the same moment, neither gets far.
constexpr Duration kLookEach = std::chrono::milliseconds(100);

}  // namespace

NamesakeAlarm::NamesakeAlarm(const TelemetrySource& source, ThreadProblems& problems)
    : source_(source),
      problems_(problems),
      watch_(source.participant, source.robot),
      began_(source.clock.now()) {}

void NamesakeAlarm::on_round() {
  const Time now = source_.clock.now();
  if (now >= next_look_) look(now);
  if (is_there_ && is_second_ && !source_.executive.held())
    source_.executive.hold_after(FaultCause::kNamesake);
}

void NamesakeAlarm::look(Time now) {
  next_look_ = now + kLookEach;
  const bool is_there = watch_.count(now) > 1;
  if (is_there == is_there_) return;
  is_there_ = is_there;
  is_second_ = is_second_ || (is_there && now - began_ < kNewcomer);
  problems_.note("name",
                 is_there ? "Another robot named " + source_.robot + " is in DDS domain " +
                                std::to_string(source_.participant.domain()) +
                                ": both obey every order and take every push; end one of them, or "
                                "start it again with another --name."
                          : "");
}

}  // namespace galilean::robot
