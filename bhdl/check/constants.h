// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "bhdl/source/diagnostic.h"
#include "bhdl/syntax/syntax.h"

namespace galilean::bhdl {

/// How many values constants may put into a program, so that constants of constants stay small.
inline constexpr std::size_t kMostConstantValues = 100'000;

/// Puts the values of `define:` wherever their names stand bare, as if they had been written there.
/// A constant may use those before it and no others, so that there are no cycles. Words that are no
/// constant's name stay. The values point into the tree's definitions. Returns the names that stand
/// nowhere.
std::vector<Word> put_in_constants(SyntaxTree& tree, Diagnostics& diagnostics);

/// Of the main file: what is included may be for other programs, too.
void warn_of_unused_constants(const std::vector<Word>& unused, std::string_view main_file,
                              Diagnostics& diagnostics);

/// "; 'name' is defined at file:line:column" of a value that a constant stood for, else nothing.
[[nodiscard]] std::string definition_note(const ValueNode& value);

}  // namespace galilean::bhdl
