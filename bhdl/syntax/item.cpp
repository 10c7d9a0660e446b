// SPDX-License-Identifier: BSD-3-Clause
#include "bhdl/syntax/item.h"

namespace galilean::bhdl {

std::vector<Item> items_of(const ParseTree& tree) {
  std::vector<Item> items;
  for (const auto root : tree.roots()) {
    items.push_back({root, std::nullopt});
    if (tree.nodes[root].kind != NodeKind::kStates) continue;
    for (const auto state : tree.children(root)) items.push_back({state, root});
  }
  return items;
}

}  // namespace galilean::bhdl
