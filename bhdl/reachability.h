#pragma once

#include "bhdl/diagnostic.h"

namespace galilean::bhdl {

/// Warns of every state that neither the start state nor a swap leads to.
void warn_of_unreachable_states(const Program& program, Diagnostics& diagnostics);

}  // namespace galilean::bhdl
