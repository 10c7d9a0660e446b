// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "core/command_line/command_line.h"

namespace galilean {

/// Adds --domain, the DDS domain from 0 to 232, to a command line. Without it `domain` stays what
/// it is: -1 stands for what ROS_DOMAIN_ID says, else 0. `note` ends the help, such as "with
/// --direct".
CommandLineOption add_domain_option(CommandLine& line, int& domain, const std::string& note = {});

}  // namespace galilean
