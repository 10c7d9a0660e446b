// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "bhdl/syntax/token_stream.h"

namespace galilean::bhdl {

/// `expect: … end`. The stream stands at the word. Within, whatever label has no value begins a
/// step.
void parse_expectation(TokenStream& tokens, Diagnostics& diagnostics);

}  // namespace galilean::bhdl
