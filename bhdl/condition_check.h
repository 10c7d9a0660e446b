#pragma once

#include "bhdl/schema_use.h"
#include "bhdl/source/diagnostic.h"
#include "bhdl/state_graph.h"

namespace galilean::bhdl {

/// Warns of conditions that never hold, that always do, and that repeat one before them. Follows
/// the first 256 of the bits that a program tests, so that it takes time in proportion to the
/// program.
void warn_of_certain_conditions(const Program& program, const SchemaUses& uses,
                                const StateGraph& graph, Diagnostics& diagnostics);

}  // namespace galilean::bhdl
