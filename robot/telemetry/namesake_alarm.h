// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "core/wire/namesakes.h"
#include "robot/telemetry/namesake_watch.h"
#include "robot/telemetry/publisher.h"
#include "robot/telemetry/thread_problems.h"

namespace galilean::robot {

/// Makes another robot of this robot's name a problem of this one, from when it is known until it
/// is gone. Both robots say so. One that runs already runs on, since an operator may rely on it.
/// One that has only just started is held, since the other was there first, and whoever resumes it
/// meanwhile, perhaps meaning the other, gets it held again. Of two that start at the same moment
/// each is the newcomer, and neither moves.
///
/// A second robot ends by itself before it tells anything (NamesakeWatch::expect_none). That it was
/// started stays a problem for a while, so that somebody sees it. If it does not end, it counts as
/// one that obeys. It may be of another release, whose messages cannot be heard here.
class NamesakeAlarm {
 public:
  /// Discovery may take longer than NamesakeWatch::kAcquaintance in a bad network. A robot that is
  /// younger than this counts as the one that came later.
  static constexpr Duration kNewcomer = std::chrono::seconds(10);
  /// A second robot listens for kAcquaintance, and then takes its time to end.
  static constexpr Duration kEndsWithin = std::chrono::seconds(4);
  /// How long it stays a problem that one was started.
  static constexpr Duration kToldFor = std::chrono::seconds(30);

  /// Requires: `problems` outlives this, and so does what `source` names.
  /// Errors: throws std::runtime_error if DDS refuses the topic.
  NamesakeAlarm(const TelemetrySource& source, ThreadProblems& problems);

  /// Publisher's thread: in every round. It looks ten times a second.
  void on_round();

 private:
  enum class Namesake : std::uint8_t { kNone, kWasStarted, kObeys };

  void look(Time now);
  [[nodiscard]] Namesake judge_joined(Time now);
  [[nodiscard]] std::string sentence() const;

  const TelemetrySource source_;
  ThreadProblems& problems_;
  NamesakeWatch watch_;
  wire::Namesakes joined_;
  Time began_;
  Time next_look_{};
  Namesake namesake_ = Namesake::kNone;
  bool is_second_ = false;  ///< another was there when this one started
  std::optional<Time> joined_since_;
  Time told_until_{};
};

}  // namespace galilean::robot
