// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "bhdl/syntax/token_stream.h"

namespace galilean::bhdl {

/// Reads `state : { attribute | list of schemas | condition } end`. Requires: the stream stands at
/// `state`, or at a misspelling of it that the caller has reported.
void parse_state(TokenStream& tokens, Diagnostics& diagnostics);

}  // namespace galilean::bhdl
