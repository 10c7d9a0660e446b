// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

#include "core/command_line/command_line.h"

namespace galilean {

/// The most robots that the simulator and the demo start on one machine. Beside them, a DDS domain
/// has room for the simulator, the monitor and a few tools.
inline constexpr std::uint64_t kMostRobots = 100;

/// Adds --robots, the number of robots, to a command line. What `robots` holds is the default.
CommandLineOption add_robots_option(CommandLine& line, std::uint64_t& robots);

}  // namespace galilean
