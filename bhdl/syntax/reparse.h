// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "bhdl/syntax/parse_tree.h"

namespace galilean::bhdl {

/// The tree of `text`, the same as parse_tree gives, made of the tree of an earlier version: only
/// the items that an edit between the two touches are read again, and what stands before and behind
/// them is copied. The mistakes in the text are not told.
[[nodiscard]] ParseTree reparsed(const ParseTree& before, std::string_view text);

}  // namespace galilean::bhdl
