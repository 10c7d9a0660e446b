// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "monitor/programs/library.h"
#include "monitor/team/team.h"

namespace galilean::monitor {

/// A robot that is to run a program, and what its programs may name.
struct Target {
  std::string robot;
  std::optional<msg::Catalog> catalog;  ///< none: it has not published it
};
[[nodiscard]] inline Target target_of(const Robot& robot) {
  return {robot.name, robot.catalog};
}

/// A program as it would be pushed to some robots.
struct TargetCheck {
  bhdl::CheckResult result;  ///< of the first robot that would refuse, else of the first
  std::string refused_by;    ///< that robot; empty if the program suits all
};

/// Checks against each robot's catalog, each different catalog once; against the one that was
/// installed where a robot has published none, and where there is no target.
[[nodiscard]] TargetCheck check_for(const std::vector<Target>& targets, const Catalog& installed,
                                    const std::function<bhdl::CheckResult(const Catalog&)>& check);
/// The same for texts, with the library's includes.
[[nodiscard]] TargetCheck check_for(const std::vector<bhdl::SourceFile>& files,
                                    const std::vector<Target>& targets,
                                    const ProgramLibrary& library);

}  // namespace galilean::monitor
