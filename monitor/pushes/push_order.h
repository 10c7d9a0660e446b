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

/// How a program is to be tried in simulation.
struct TrialWish {
  bool wanted = false;
  bool only = false;           ///< the program is tried and pushed to nobody
  bool even_if_worse = false;  ///< the program is pushed though it scores clearly less
  int seeds = 8;
  double duration_s = 120;  ///< simulated
  std::string scenario;     ///< the arena; empty: that of the referee who is heard
};

/// What an operator asks for: this program, for those robots, on this way.
struct PushOrder {
  std::vector<bhdl::SourceFile> files;  ///< the main file first
  std::vector<std::string> targets;     ///< empty: the team
  std::string author;
  std::string replaces =
      {};  ///< refuse where another program than this hash runs; empty: whatever runs
  TrialWish trial = {};
  std::string canary = {};                 ///< the robot that runs it first; empty: all at once
  std::optional<Duration> probation = {};  ///< of each robot, and of the canary before the others
};

/// What tells one push from all others.
struct PushIdentity {
  std::string id;
  std::string rollback_id = {};  ///< of the order that takes it off the canary again
  std::int64_t pushed_ns = 0;    ///< since the Unix epoch
};

/// The robots that an order means.
struct OrderTargets {
  std::vector<Target> awaited;      ///< with what their programs may name
  std::vector<std::string> silent;  ///< of the team, but not heard for a while

  [[nodiscard]] std::vector<std::string> names() const;  ///< of `awaited`
};
/// `named`: robots' names; empty: the team.
[[nodiscard]] OrderTargets targets_of(const std::vector<std::string>& named, const Team& team);
/// Errors: a robot that is named is unknown (kNotFound); nobody is there to take the program, or
/// the canary is none of those who are (kConflict).
[[nodiscard]] Result<void, Refusal> require_targets(const PushOrder& order,
                                                    const OrderTargets& targets, const Team& team);

/// Returns the program that runs where it is another one than the order is to replace.
[[nodiscard]] std::optional<Stale> stale(const PushOrder& order, const OrderTargets& targets,
                                         const Team& team);

/// Returns the hash that each of `robots` is told that it replaces: none where one of them drifts,
/// which would refuse.
[[nodiscard]] std::string replaced_by_each(const std::string& replaces,
                                           const std::vector<Target>& robots, const Team& team);

/// Returns whether two orders mean a robot in common.
[[nodiscard]] bool overlap(const std::vector<std::string>& targets,
                           const std::vector<std::string>& others);

}  // namespace galilean::monitor
