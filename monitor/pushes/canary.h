// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>

#include "monitor/pushes/replies.h"
#include "monitor/pushes/verdict.h"

namespace galilean::monitor {

/// The robot that runs a program alone for its probation, before the others get it. Pure: what the
/// robot replies and shows, and the time, come from outside.
class Canary {
 public:
  Canary(const std::string& push_id, std::string robot, Duration probation, Time sent);

  /// Returns false if the reply belongs to another push or tells nothing new.
  bool note(const msg::ProgramReply& reply, Time now) { return replies_.note(reply, now); }
  /// Judges by its replies and the time: the step is under way once the robot runs the program, and
  /// done at the end of its probation.
  [[nodiscard]] Verdict judge(Time now);
  /// Judges by what is heard of the robot besides its replies, once it runs the program.
  [[nodiscard]] Verdict see(bool silent, const std::string& running_hash, Time now) const;

  /// Returns false once it has refused the program, or has gone back by itself.
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
