// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "core/result.h"

namespace galilean::front {

/// Checks the program that a demo's robots are to run, as each of them would.
/// @param bhdl  a file, or the name of a program that ships
/// Errors: it has errors, which the message tells as the checker does, a line each.
[[nodiscard]] Result<void> check_program(const std::string& bhdl);

}  // namespace galilean::front
