// SPDX-License-Identifier: BSD-3-Clause
#include "bhdl/lint/program_check.h"

#include "bhdl/check/constants.h"
#include "bhdl/lint/condition_check.h"
#include "bhdl/lint/device_check.h"
#include "bhdl/lint/idle_check.h"
#include "bhdl/lint/reachability.h"
#include "bhdl/lint/stop_check.h"
#include "bhdl/lint/wiring_check.h"

namespace galilean::bhdl {

void warn_of_suspects(const Program& program, const Vocabulary& vocabulary, const ProgramText& text,
                      Diagnostics& diagnostics) {
  const StateGraph graph(program);
  const SchemaUses uses(program, vocabulary);
  warn_of_unreachable_states(program, graph, text.extended, diagnostics);
  warn_of_dead_ends(program, graph, diagnostics);
  warn_of_endless_driving(program, uses, graph, diagnostics);
  warn_of_certain_conditions(program, uses, graph, diagnostics);
  warn_of_wiring(program, uses, text.tree, diagnostics);
  warn_of_unnamed_devices(program, uses, vocabulary, diagnostics);
  warn_of_unwritten_variables(program, uses, vocabulary, diagnostics);
  warn_of_unused_constants(text.unused_constants, text.main_file, diagnostics);
  warn_of_unused_schemas(program, uses, text, diagnostics);
  warn_of_gains_without_effect(program, uses, vocabulary, diagnostics);
}

}  // namespace galilean::bhdl
