// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "robot/telemetry/namesake_watch.h"
#include "robot/telemetry/publisher.h"
#include "robot/telemetry/thread_problems.h"

namespace galilean::robot {

/// Makes another robot of this robot's name a problem of this one, from when it is heard until it
/// is gone. Both robots say so. One that runs already runs on, since an operator may rely on it.
/// One that has only just started is held, since the other was there first, and whoever resumes it
/// meanwhile, perhaps meaning the other, gets it held again. Of two that start at the same moment
/// each is the newcomer, and neither moves.
class NamesakeAlarm {
 public:
  /// Discovery may take longer than NamesakeWatch::kAcquaintance in a bad network. A robot that is
  /// younger than this counts as the one that came later.
  static constexpr Duration kNewcomer = std::chrono::seconds(10);

  /// Requires: `problems` outlives this, and so does what `source` names.
  /// Errors: throws std::runtime_error if DDS refuses the topic.
  NamesakeAlarm(const TelemetrySource& source, ThreadProblems& problems);

  /// Publisher's thread: in every round. It looks ten times a second.
  void on_round();

 private:
  void look(Time now);

  const TelemetrySource source_;
  ThreadProblems& problems_;
  NamesakeWatch watch_;
  Time began_;
  Time next_look_{};
  bool is_there_ = false;
  bool is_second_ = false;  ///< another was there when this one started
};

}  // namespace galilean::robot
