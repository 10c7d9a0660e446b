// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "core/catalog/catalog.h"

namespace galilean::bhdl {

/// Runs `galilean bhdl diff`: prints what makes two programs different, in words or as JSON.
/// Returns the exit status: 0 if nothing differs, 1 if something does, 2 if one of the files is no
/// program.
[[nodiscard]] int run_diff(const std::string& from, const std::string& to, bool json,
                           const Catalog& catalog);

}  // namespace galilean::bhdl
