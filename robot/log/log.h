// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string_view>

namespace galilean::robot {

// Each writes one line to the robot's log: to standard error, and to LogForwarding. spdlog keeps
// the log. Only this room includes spdlog's headers, because a file that includes them takes
// seconds to compile. Any thread but the control loop may call them.

void log_info(std::string_view line);
/// For a problem with which the robot can go on.
void log_warning(std::string_view line);
/// For something that did not happen.
void log_error(std::string_view line);

}  // namespace galilean::robot
