// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "robot/telemetry/break_desk.h"
#include "robot/telemetry/publisher.h"
#include "robot/telemetry/thread_problems.h"

namespace galilean::robot {

/// Has kept for a start after a crash who holds the robot, and whether it is out of service. Of a
/// robot that is held since before such a start it says so among its problems, until somebody lets
/// it go on. A hold after a fault is not kept, because a crash causes one of its own.
class HoldKeeper {
 public:
  /// Requires: what is given outlives this, and so does what `source` names.
  HoldKeeper(const TelemetrySource& source, const BreakDesk& desk, ThreadProblems& problems);

  /// Publisher's thread: in every round.
  void on_round(const Snapshot& newest);

 private:
  [[nodiscard]] std::string holder_in(const Snapshot& newest) const;

  const TelemetrySource source_;
  const BreakDesk& desk_;
  ThreadProblems& problems_;
  bool is_held_since_before_;
  std::string held_by_;  ///< as it was kept last
  bool out_of_service_;  ///< the same
};

}  // namespace galilean::robot
