// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "bhdl/lint/schema_use.h"
#include "bhdl/lint/state_graph.h"
#include "bhdl/source/diagnostic.h"

namespace galilean::bhdl {

/// Warns of conditions that never hold, that always hold, and that repeat one before them. Follows
/// only the first 256 of the bits that a program tests, so that its time is in proportion to the
/// program.
void warn_of_certain_conditions(const Program& program, const SchemaUses& uses,
                                const StateGraph& graph, Diagnostics& diagnostics);

}  // namespace galilean::bhdl
