// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "core/command_line/command_line.h"

namespace galilean {

/// Adds --domain, the DDS domain from 0 to 232, to a command line. Without it `domain` keeps its
/// value, where -1 stands for ROS_DOMAIN_ID, or 0 if that is not set. `note` ends the help, such as
/// "with --direct". Adds --secure beside it, the folder with the program's keys for DDS Security,
/// so that no program that joins a domain lacks it.
CommandLineOption add_domain_option(CommandLine& line, int& domain, const std::string& note = {});

}  // namespace galilean
