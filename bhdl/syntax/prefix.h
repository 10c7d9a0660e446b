// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "bhdl/syntax/label_resolver.h"

namespace galilean::bhdl {

/// The last items of a text that ends at the cursor. If they stand in a `states:` that begins
/// before them, a node that begins with them takes its place.
struct Prefix {
  ParseTree tree;
  std::optional<std::uint32_t> states;  ///< the node of that `states:` in the whole tree
};

/// Reads `whole.text` up to `end` as if nothing followed. It begins at the last item that surely
/// begins before. Takes time linear in the items that it reads, which are few.
[[nodiscard]] Prefix parse_prefix(const ParseTree& whole, std::size_t end,
                                  const LabelResolver& resolver);

}  // namespace galilean::bhdl
