// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include "bhdl/syntax/parse_tree.h"

namespace galilean::bhdl {

/// A place where reading may begin (see FileParser).
struct Item {
  std::uint32_t node = 0;
  std::optional<std::uint32_t> states;  ///< the node of the `states:` that the item stands in
};

/// Returns the items in the order of the text.
[[nodiscard]] std::vector<Item> items_of(const ParseTree& tree);

}  // namespace galilean::bhdl
