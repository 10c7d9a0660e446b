// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "bhdl/syntax/parse_tree.h"

namespace galilean::bhdl {

/// Adds what a file says to `result`, without comments, punctuation and incomplete parts. The views
/// of `result` point into `file` and into the tree's text.
void lower_into(SyntaxTree& result, const ParseTree& tree, std::string_view file);
[[nodiscard]] SyntaxTree lowered(const ParseTree& tree, std::string_view file);
/// Returns the paths that the file's includes name.
[[nodiscard]] std::vector<std::string_view> includes_of(const ParseTree& tree);

}  // namespace galilean::bhdl
