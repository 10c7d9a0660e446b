// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "bhdl/syntax/token_stream.h"

namespace galilean::bhdl {

/// Reads `expect: … end`. Inside, every label without a value begins a step. Requires: the stream
/// stands at the word.
void parse_expectation(TokenStream& tokens, Diagnostics& diagnostics);

}  // namespace galilean::bhdl
