// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>

#include "monitor/expect/judge/verdict.h"

namespace galilean::expect {

/// What came of each claim that concerns a robot, in the order of the file.
struct RobotFindings {
  bool heard = false;
  std::vector<Finding> findings;
};
/// By the robot's name; an empty name is the team.
using Collected = std::map<std::string, RobotFindings>;

/// Returns whether an expectation of this scope is about the robot.
[[nodiscard]] bool concerns(const Scope& scope, const std::string& robot);

/// Makes verdicts of the robots' findings: one for each claim and robot, and one for each
/// expectation about some robot.
[[nodiscard]] std::vector<Verdict> collect(const std::vector<Expectation>& expectations,
                                           Collected& collected);

}  // namespace galilean::expect
