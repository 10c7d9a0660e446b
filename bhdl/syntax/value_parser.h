#pragma once

#include <vector>

#include "bhdl/syntax/token_stream.h"

namespace galilean::bhdl {

/// value { [","] value }. A broken pair is reported and kept as kBroken, so that the attribute
/// counts as given.
[[nodiscard]] std::vector<ValueNode> parse_values(TokenStream& tokens, Diagnostics& diagnostics);

}  // namespace galilean::bhdl
