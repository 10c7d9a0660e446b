// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "bhdl/lint/program_check.h"
#include "bhdl/lint/schema_use.h"
#include "bhdl/source/diagnostic.h"

namespace galilean::bhdl {

/// Warns of a variable that a listed schema reads, that no schema writes and that is not valid from
/// the start.
void warn_of_unwritten_variables(const Program& program, const SchemaUses& uses,
                                 const Vocabulary& vocabulary, Diagnostics& diagnostics);

/// Warns of schemas of the main file that no state lists and none extends. An included file may
/// offer more than one program uses.
void warn_of_unused_schemas(const Program& program, const SchemaUses& uses, const ProgramText& text,
                            Diagnostics& diagnostics);

/// Warns of gains of 0, and of gains of schemas whose force nobody reads.
void warn_of_gains_without_effect(const Program& program, const SchemaUses& uses,
                                  const Vocabulary& vocabulary, Diagnostics& diagnostics);

}  // namespace galilean::bhdl
