// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <chrono>
#include <optional>
#include <string>
#include <vector>

#include "bhdl/program/program.h"
#include "core/clock.h"
#include "monitor/pushes/target_check.h"
#include "monitor/team/team.h"

namespace galilean::monitor {

/// How a program is to be tried in simulation.
struct TrialWish {
  bool wanted = false;
  bool only = false;           ///< and then pushed to nobody
  bool even_if_worse = false;  ///< push it though it scores clearly less
  int seeds = 8;
  double duration_s = 120;  ///< simulated
  std::string scenario;     ///< the arena; empty: that of the referee who is heard
};

/// What an operator asks for: this program, for those robots, on this way.
struct PushOrder {
  std::vector<bhdl::SourceFile> files;  ///< the main file first
  std::vector<std::string> targets;     ///< empty: the team
  std::string author;
  std::string replaces;  ///< refuse where another program than this hash runs; empty: whatever runs
  TrialWish trial = {};
  std::string canary;                      ///< the robot that runs it first; empty: all at once
  std::optional<Duration> probation = {};  ///< of each robot, and of the canary before the others
};

/// The robots that an order means, and what may stand against it.
struct OrderTargets {
  std::vector<Target> awaited;      ///< with what their programs may name
  std::vector<std::string> silent;  ///< of the team, but not heard for a while
  int status = 200;                 ///< else 404 or 409, with `objection`
  std::string objection;            ///< one sentence

  [[nodiscard]] std::vector<std::string> names() const;  ///< of `awaited`
};
[[nodiscard]] OrderTargets targets_of(const PushOrder& order, const Team& team);

/// Another program than the one that the order is to replace, where one runs.
struct Stale {
  std::string robot;  ///< that runs it; empty: the team as a whole
  std::string hash;
};
[[nodiscard]] std::optional<Stale> stale(const PushOrder& order, const OrderTargets& targets,
                                         const Team& team);

/// What each robot is told that it replaces: nothing where one of them drifts, which would refuse.
[[nodiscard]] std::string replaced_by_each(const PushOrder& order, const OrderTargets& targets,
                                           const Team& team);

/// Whether two orders mean a robot in common.
[[nodiscard]] bool overlap(const std::vector<std::string>& targets,
                           const std::vector<std::string>& others);

}  // namespace galilean::monitor
