// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "bhdl/lint/schema_use.h"
#include "bhdl/lint/state_graph.h"
#include "bhdl/source/diagnostic.h"

namespace galilean::bhdl {

/// Warns once of a program that can get to where nothing stops the motors any more. That is a state
/// that lists a schema which drives the motors, and from which every way leads through such states
/// only. A program of one state is not warned of.
void warn_of_endless_driving(const Program& program, const SchemaUses& uses,
                             const StateGraph& graph, Diagnostics& diagnostics);

}  // namespace galilean::bhdl
