// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "bhdl/syntax/token_stream.h"

namespace galilean::bhdl {

/// Reads `value { [","] value }`. A value that cannot be read is reported and kept as
/// ValueSense::kBroken, so that the attribute counts as given.
void parse_values(TokenStream& tokens, Diagnostics& diagnostics);

/// Returns the unit of that symbol, or nullptr if there is none.
[[nodiscard]] const Unit* known_unit(std::string_view symbol) noexcept;

}  // namespace galilean::bhdl
