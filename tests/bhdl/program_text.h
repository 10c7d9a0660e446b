// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "bhdl/program/program.h"

namespace galilean::bhdl {

/// Returns everything that a program says, without the positions in its text. Two programs that do
/// the same have the same text.
[[nodiscard]] std::string meaning(const Program& program);

}  // namespace galilean::bhdl
