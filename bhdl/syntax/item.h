// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include "bhdl/syntax/parse_tree.h"

namespace galilean::bhdl {

/// Where reading may begin (FileParser).
struct Item {
  std::uint32_t node = 0;
  std::optional<std::uint32_t> states;  ///< the node of the `states:` that it stands in
};

/// In the order of the text.
[[nodiscard]] std::vector<Item> items_of(const ParseTree& tree);

}  // namespace galilean::bhdl
