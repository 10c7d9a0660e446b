// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "bhdl/source/diagnostic.h"
#include "bhdl/syntax/syntax.h"

namespace galilean::bhdl {

/// How many values constants may put into a program. The limit keeps constants of constants small.
inline constexpr std::size_t kMostConstantValues = 100'000;

/// Puts the values of `define:` wherever their names stand as bare words. A constant may use only
/// those before it, so that there are no cycles. Words that name no constant stay. The values point
/// into the tree's definitions. Returns the names that nothing uses.
std::vector<Word> put_in_constants(SyntaxTree& tree, Diagnostics& diagnostics);

/// Warns of unused constants of the main file alone, because an included file may serve other
/// programs.
void warn_of_unused_constants(const std::vector<Word>& unused, std::string_view main_file,
                              Diagnostics& diagnostics);

/// Returns "; 'name' is defined at file:line:column" if a constant stood for the value, else an
/// empty text.
[[nodiscard]] std::string definition_note(const ValueNode& value);

}  // namespace galilean::bhdl
