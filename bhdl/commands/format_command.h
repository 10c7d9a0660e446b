// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

namespace galilean::bhdl {

/// Runs `galilean bhdl fmt`: lays files out in place and prints the names of those that it changed.
/// `-` is standard input, which is laid out to standard output. With `check_only` nothing is
/// written. Returns the exit status: 1 if a file could not be laid out or written, or if
/// `check_only` and one would change; else 0.
[[nodiscard]] int run_format(const std::vector<std::string>& files, bool check_only);

}  // namespace galilean::bhdl
