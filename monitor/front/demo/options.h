// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace galilean::front {

/// The options of `galilean demo`.
struct DemoOptions {
  std::uint64_t robots = 3;
  int port = 8080;
  std::string scenario = "office";
  std::string bhdl = "office_cleanup";  ///< a file, or the name of an installed program
  bool watch = false;                   ///< the robots swap to the file whenever it is saved
  std::uint64_t seed = 1;
  std::optional<double> headless_for_s;
  std::string record;  ///< the recording's file; empty for none, or for one among the run's logs
  std::vector<std::string> expectations;     ///< by which the recording is judged: files, or names
  std::string junit;                         ///< where to write what came of them; empty: nowhere
  std::vector<std::string> allowed_origins;  ///< other sites whose pages may use the monitor
  int domain = -1;  ///< the DDS domain; negative: that of ROS_DOMAIN_ID, else 0
};

/// Reads the options. Returns nothing if the demo is to run, and the exit code otherwise.
[[nodiscard]] std::optional<int> read_options(int count, const char* const* arguments,
                                              DemoOptions& options);

}  // namespace galilean::front
