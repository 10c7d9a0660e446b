// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string_view>

namespace galilean::robot {

// One line each for the robot's log: standard error, and who else listens (LogForwarding). spdlog
// keeps the log; its headers are included in this room alone, because a file that includes them
// takes seconds to compile. Any thread but the control loop.

void log_info(std::string_view line);
/// Of what the robot can go on with.
void log_warning(std::string_view line);
/// Of what did not happen.
void log_error(std::string_view line);

}  // namespace galilean::robot
