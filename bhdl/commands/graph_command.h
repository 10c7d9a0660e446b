// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "core/catalog/catalog.h"

namespace galilean::bhdl {

/// Runs `galilean bhdl graph`: prints a program's state machine. `format` is "dot", "svg" or
/// "json". Returns the exit status: 0, or 1 if the file is no program.
[[nodiscard]] int run_graph(const std::string& file, const std::string& format,
                            const Catalog& catalog);

}  // namespace galilean::bhdl
