// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "bhdl/program/program.h"

namespace galilean::bhdl {

/// Everything that a program says, and nothing of where it says so: two programs that do the same
/// have the same text.
[[nodiscard]] std::string meaning(const Program& program);

}  // namespace galilean::bhdl
