// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "core/result.h"

namespace galilean::front {

/// Runs a program to its end, and returns what it prints on standard output. `command` is its path
/// and arguments.
/// Errors: the program cannot be started, or its exit code is not 0.
[[nodiscard]] Result<std::string> program_output(const std::vector<std::string>& command);

}  // namespace galilean::front
