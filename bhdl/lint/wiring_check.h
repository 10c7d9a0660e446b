// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "bhdl/lint/schema_use.h"
#include "bhdl/source/diagnostic.h"
#include "bhdl/syntax/syntax.h"

namespace galilean::bhdl {

/// Warns in each state of motor schemas that overwrite each other's result, or each other's command
/// to a device, whose result nothing reads, and that are listed behind their reader. The tree says
/// where they are listed.
void warn_of_wiring(const Program& program, const SchemaUses& uses, const SyntaxTree& tree,
                    Diagnostics& diagnostics);

}  // namespace galilean::bhdl
