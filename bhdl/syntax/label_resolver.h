// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "bhdl/syntax/parse_tree.h"

namespace galilean::bhdl {

/// Answers what a label without a value means, from knowledge of the catalog. Where a text breaks
/// off at such a label, as it does while it is typed, the grammar alone cannot decide.
class LabelResolver {
 public:
  virtual ~LabelResolver() = default;
  /// Returns whether a block of this kind and type has an attribute of that name.
  [[nodiscard]] virtual bool is_attribute(NodeKind block, std::string_view type,
                                          std::string_view label) const = 0;
  [[nodiscard]] virtual bool is_component(std::string_view label) const = 0;
};

}  // namespace galilean::bhdl
