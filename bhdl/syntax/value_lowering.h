// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "bhdl/syntax/parse_tree.h"

namespace galilean::bhdl {

/// Returns the value of a node. Requires: its kind is kValue.
[[nodiscard]] ValueNode lowered_value(const ParseTree& tree, const Node& node,
                                      std::string_view file);

}  // namespace galilean::bhdl
