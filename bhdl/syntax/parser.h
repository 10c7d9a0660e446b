// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string_view>

#include "bhdl/source/diagnostic.h"
#include "bhdl/syntax/parse_tree.h"

namespace galilean::bhdl {

/// Reads one file (GRAMMAR.md). This is the only reader of the language. It knows the language's
/// own words and no component. It reports what it cannot read, and goes on at the next attribute,
/// component or section. No nesting of the text makes it recurse.
///
/// The tree's views point into `text`.
[[nodiscard]] ParseTree parse_tree(std::string_view file, std::string_view text,
                                   Diagnostics& diagnostics);

/// Reads a file and returns only what the checker needs. Not more than one item of the parse tree
/// is in memory at a time. The tree's views point into `file` and `text`.
[[nodiscard]] SyntaxTree parse(std::string_view file, std::string_view text,
                               Diagnostics& diagnostics);

}  // namespace galilean::bhdl
