// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace galilean::sim {

/// The options on the command line.
struct Options {
  bool headless = false;
  bool live = false;
  bool json = false;
  std::string scenario = "office";
  std::string bhdl = "office_cleanup";
  std::uint64_t robots = 3;
  std::uint64_t seed = 1;
  double duration_s = 0;  ///< 0: the scenario's
  std::string start;      ///< a file: the situation to go on from; empty: the scenario's start
  std::string trace;
  std::string snapshot;
  std::string snapshot_robot = "io";
  std::string run = "demo";
  std::optional<double> autostart_s;
  std::vector<std::string> faults;
  int domain = -1;
};

inline constexpr int kBadInput = 2;
inline constexpr int kFailed = 1;

/// Runs what the options ask for. Returns the process's exit code. Errors are one line on stderr.
[[nodiscard]] int run(const Options& options);

}  // namespace galilean::sim
