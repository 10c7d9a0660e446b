// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "bhdl/diff/change.h"
#include "bhdl/program/program.h"
#include "core/catalog/catalog.h"

namespace galilean::bhdl {

/// Returns what makes two programs different for a robot. The order is: start state, states with
/// their transitions, on_swap, devices, variables, schemas. Layout, comments, files and the order
/// of declarations do not count. The order of a state's schemas and conditions does. The catalog
/// names the units. Time is linear in the programs.
[[nodiscard]] std::vector<Change> differences(const Program& from, const Program& to,
                                              const Catalog& catalog);

}  // namespace galilean::bhdl
