// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>

#include "monitor/pushes/history/replies.h"
#include "monitor/pushes/rollout/verdict.h"

namespace galilean::monitor {

/// The robot that runs a program alone for a probation, before the others get it. The class does no
/// input or output: its owner brings the robot's replies, its state and the time.
class Canary {
 public:
  Canary(const std::string& push_id, std::string robot, Duration probation, Time sent);

  /// Takes in a reply. Returns false if it belongs to another push or tells nothing new.
  bool note(const msg::ProgramReply& reply, Time now) { return replies_.note(reply, now); }
  /// Judges the canary by its replies and the time. The step is under way once the robot runs the
  /// program, and done at the end of the probation.
  [[nodiscard]] Verdict judge(Time now);
  /// Judges the canary by what is heard of it besides its replies. The step fails if the robot
  /// falls silent or runs another program after it had begun to run this one.
  [[nodiscard]] Verdict see(bool silent, const std::string& running_hash, Time now) const;

  /// Returns false once the robot has refused the program or rolled it back.
  [[nodiscard]] bool may_run_it() const;
  [[nodiscard]] RobotReply reply() const { return replies_.all().front(); }

 private:
  std::string robot_;
  Duration probation_;
  Time sent_;
  Replies replies_;
  std::optional<Time> runs_since_;
};

}  // namespace galilean::monitor
