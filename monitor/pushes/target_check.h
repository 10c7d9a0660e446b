// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "monitor/programs/library.h"
#include "monitor/team/team.h"

namespace galilean::monitor {

/// A robot that is to run a program, and its catalog.
struct Target {
  std::string robot;
  std::optional<msg::Catalog> catalog;  ///< none: the robot has not published one
};
[[nodiscard]] inline Target target_of(const Robot& robot) {
  return {robot.name, robot.catalog};
}

/// Returns whether a robot takes a program that is pushed to all. One that is out of service does
/// not, and where a recording plays a robot, nobody is there.
[[nodiscard]] bool takes_what_all_take(const Robot& robot, const Team& team);

/// The check of a program for the robots that are to run it.
struct TargetCheck {
  bhdl::CheckResult result;  ///< for the first robot that would refuse it, else for the first
  std::string refused_by;    ///< the robot that would refuse it; empty: none
  std::vector<TakenFile> taken = {};  ///< what was not sent, and came from the library
};

/// Checks a program against the catalogs of `targets`, each different catalog once. `installed`
/// takes the place of a catalog that was not published or cannot be read, and serves where there
/// is no target.
[[nodiscard]] TargetCheck check_for(const std::vector<Target>& targets, const Catalog& installed,
                                    const std::function<bhdl::CheckResult(const Catalog&)>& check);
/// Checks `files`. The library has the files that they include.
[[nodiscard]] TargetCheck check_for(const std::vector<bhdl::SourceFile>& files,
                                    const std::vector<Target>& targets,
                                    const ProgramLibrary& library);

}  // namespace galilean::monitor
