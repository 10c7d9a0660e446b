// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "robot/rerun/rerun.h"

namespace galilean::robot {

/// How a run that was run again is told of.
struct RerunReport {
  std::string title;     ///< which run it is: "run.mcap /io/inputs"
  bool as_json = false;  ///< one line
  bool other_program = false;
};

/// Returns what became of the run, ending with a newline. `took_s` is the time that it took.
[[nodiscard]] std::string describe(const RerunReport& report, const RerunResult& result,
                                   double took_s);

/// Returns 0 if no bit differs, kFailed if one does, and kIncomplete if that cannot be told of the
/// whole run.
[[nodiscard]] int exit_code(const RerunResult& result) noexcept;

}  // namespace galilean::robot
