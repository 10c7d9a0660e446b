// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "bhdl/check/extension.h"
#include "bhdl/lint/state_graph.h"
#include "bhdl/source/diagnostic.h"

namespace galilean::bhdl {

/// Warns of every state that neither the start state nor a swap leads to and that none extends.
void warn_of_unreachable_states(const Program& program, const StateGraph& graph,
                                const ExtendedNames& extended, Diagnostics& diagnostics);

/// Warns of a state that runs motor schemas, or has conditions, and is never left for another, in a
/// program that gets to other states. A state that has neither is meant as an end.
void warn_of_dead_ends(const Program& program, const StateGraph& graph, Diagnostics& diagnostics);

}  // namespace galilean::bhdl
