// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "bhdl/program/program.h"
#include "core/clock.h"
#include "core/result.h"
#include "monitor/pushes/refusal.h"
#include "monitor/pushes/target_check.h"
#include "monitor/team/team.h"

namespace galilean::monitor {

/// How to try a program in simulation.
struct TrialOptions {
  bool wanted = false;
  bool only = false;           ///< the program is tried, but not pushed
  bool even_if_worse = false;  ///< the program is pushed even if it scores clearly less
  int seeds = 8;
  double duration_s = 120;  ///< simulated time
  std::string scenario;     ///< the arena; empty: the one that the referee's score names
};

/// An operator's order to push a program.
struct PushOrder {
  std::vector<bhdl::SourceFile> files;  ///< the main file first
  std::vector<std::string> targets;     ///< empty: the team
  std::string author;
  /// The hash of the program to replace. If another program runs, the order is refused. Empty: the
  /// order replaces whatever runs.
  std::string replaces = {};
  TrialOptions trial = {};
  std::string canary = {};                 ///< the robot that runs it first; empty: all at once
  std::optional<Duration> probation = {};  ///< of each robot; the rest waits for the canary's
  /// The push's id, if who orders it has given one: so that an order that comes twice is one push.
  std::string id = {};
};

/// The identity of a push.
struct PushIdentity {
  std::string id;
  std::string rollback_id = {};  ///< the id of the order that takes it off the canary again
  std::int64_t pushed_ns = 0;    ///< since the Unix epoch
};

/// The robots that an order is for.
struct OrderTargets {
  std::vector<Target> awaited;      ///< the program is checked against their catalogs
  std::vector<std::string> silent;  ///< the team's other robots, which were not heard for a while;
                                    ///< they must reply, too

  [[nodiscard]] std::vector<std::string> names() const;  ///< the names of `awaited`
};
/// Returns the robots with the names `named`; if it is empty, all that are in service and that no
/// recording plays.
[[nodiscard]] OrderTargets targets_of(const std::vector<std::string>& named, const Team& team);
/// Checks that the order has robots to go to. Errors: it names an unknown robot (kNotFound), or
/// one that a recording plays (kConflict); no robot is awaited, or the canary is not one of the
/// awaited robots (kConflict).
[[nodiscard]] Result<void, Refusal> require_targets(const PushOrder& order,
                                                    const OrderTargets& targets, const Team& team);

/// Returns the hash of the program that the order's robots run; empty if it is not known. The
/// team's is the one that it is meant to run.
[[nodiscard]] std::string runs_now(const PushOrder& order, const OrderTargets& targets,
                                   const Team& team);
/// Returns the program that runs, if it is not the one that the order is to replace.
[[nodiscard]] std::optional<Stale> stale(const PushOrder& order, const OrderTargets& targets,
                                         const Team& team);

/// Returns ProgramPush::replaces_hash for `robots`: `replaces` if all of them run that program,
/// else an empty string. With the hash, a robot that runs another program would refuse the push.
[[nodiscard]] std::string replaced_by_each(const std::string& replaces,
                                           const std::vector<Target>& robots, const Team& team);

/// Returns whether two orders have a robot in common. An empty list stands for the team.
[[nodiscard]] bool overlap(const std::vector<std::string>& targets,
                           const std::vector<std::string>& others);

}  // namespace galilean::monitor
