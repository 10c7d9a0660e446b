// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "bhdl/syntax/label_sense.h"

namespace galilean::bhdl {

/// The last items of a text that breaks off, which is what somebody sees who types. In place of the
/// `states:` that they stand in, which begins before, stands a node that begins with them.
struct Beginning {
  ParseTree tree;
  std::optional<std::uint32_t> states;  ///< the true node of that `states:`, in the whole tree
};

/// Reads `whole.text` up to `end` as if nothing followed, from the last item on that surely begins
/// before. Takes time linear in the items that it reads, which are few.
[[nodiscard]] Beginning read_beginning(const ParseTree& whole, std::size_t end,
                                       const LabelSense& sense);

}  // namespace galilean::bhdl
