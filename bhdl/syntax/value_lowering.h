// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "bhdl/syntax/parse_tree.h"

namespace galilean::bhdl {

/// Of a node of kind kValue.
[[nodiscard]] ValueNode lowered_value(const ParseTree& tree, const Node& node,
                                      std::string_view file);

}  // namespace galilean::bhdl
