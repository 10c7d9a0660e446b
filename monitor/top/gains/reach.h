// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "monitor/team/team.h"

namespace galilean::monitor::top {

/// Whom a change of numbers reaches, and what they run.
struct Reach {
  std::vector<std::string> robots;        ///< those that it reaches
  std::vector<std::string> targets;       ///< whom a push names; empty: the whole team
  const msg::Program* program = nullptr;  ///< what they all run; none: they differ, or nobody told
  const msg::Catalog* catalog = nullptr;  ///< of the first of them
};

/// Returns the reach of one robot, or of the team if `robot` is empty: of the team those that are
/// in service and heard, and not played by a recording, because nobody knows what a silent robot
/// runs.
[[nodiscard]] Reach reach_of(const Team& team, const std::string& robot);

}  // namespace galilean::monitor::top
