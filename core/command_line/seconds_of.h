// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "core/command_line/command_line.h"
#include "core/result.h"

namespace galilean {

/// Reads a time such as "10", "10s", "500ms", "2min" or "1h". Returns seconds, at least 0.
/// Errors: the text is no such time.
[[nodiscard]] Result<double> seconds_of(const std::string& text);

/// Adds an option that takes a time above 0, as seconds_of reads it.
CommandLineOption add_seconds_option(CommandLine& line, const std::string& names, double& target_s,
                                     const std::string& help);

}  // namespace galilean
