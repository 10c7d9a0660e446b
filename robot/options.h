// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace galilean::robot {

/// The options on the command line of galilean-robot.
struct Options {
  std::string name = "io";
  std::string bhdl_file;
  std::string watched_file;           ///< the program whose saves cause a swap; empty: none
  std::optional<std::string> serial;  ///< instead of the program's comm_port device
  std::optional<std::string> camera;  ///< instead of the program's frame_grabber device
  int domain = -1;                    ///< of DDS; -1: as ROS_DOMAIN_ID says, else 0
  std::uint64_t seed = 1;
  double rate_hz = 20;
  double probation_s = 10;
  int most_transitions_per_s = 10;
  bool resumes_by_itself = false;  ///< after a fault, in place of being held
  bool fresh = false;              ///< begins with bhdl_file, whatever ran before
  bool keeps_nothing = false;      ///< for the next start, and knows nothing of the one before
  std::vector<std::string> accept_swaps_from;  ///< empty: only the monitor's
  std::string trust_file;  ///< the public keys whose orders move the robot; empty: anybody's do
  std::string log_level = "info";
  bool print_catalog = false;
};

/// The options, or the exit code: 0 if help was asked for, 2 if the options are wrong and the
/// reason was printed.
struct ParsedOptions {
  std::optional<Options> options;
  int exit_code = 0;
};
[[nodiscard]] ParsedOptions parse_options(int argc, const char* const* argv);

}  // namespace galilean::robot
