// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "bhdl/syntax/parse_tree.h"

namespace galilean::bhdl {

/// What a file says, without how it is written: no comments, no punctuation, nothing that is
/// incomplete. The result's views point into `file` and into the tree's text.
void lower_into(SyntaxTree& result, const ParseTree& tree, std::string_view file);
[[nodiscard]] SyntaxTree lowered(const ParseTree& tree, std::string_view file);
/// Returns the paths that the file's includes name.
[[nodiscard]] std::vector<std::string_view> includes_of(const ParseTree& tree);

}  // namespace galilean::bhdl
