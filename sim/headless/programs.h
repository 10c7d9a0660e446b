// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "bhdl/check.h"
#include "core/catalog/catalog.h"
#include "core/result.h"

namespace galilean::sim {

/// Reads and checks a BHDL file. It is a path, or the name of a program that ships
/// ("office_cleanup"). Errors: the program has errors; the message holds every diagnostic, one a
/// line.
[[nodiscard]] Result<bhdl::Program> load_program(const std::string& name_or_path,
                                                 const Catalog& catalog);

}  // namespace galilean::sim
