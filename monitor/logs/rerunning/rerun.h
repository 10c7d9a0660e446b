// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

namespace galilean::logs {

/// What `galilean log rerun` is asked for.
struct RerunOptions {
  std::vector<std::string> files;   ///< the parts of one recording, in their order
  std::vector<std::string> robots;  ///< none: all
  std::string bhdl_file;            ///< the program that is run instead; empty: the recorded one
  bool json = false;
};

/// Runs robots again from what a recording says that their ticks read, and prints what became of
/// each run. A process of the robot's side does that: nothing here knows a robot. Returns the exit
/// code.
[[nodiscard]] int rerun_recordings(const RerunOptions& options);

}  // namespace galilean::logs
