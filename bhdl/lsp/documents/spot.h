// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include "bhdl/lsp/documents/entity.h"
#include "bhdl/lsp/documents/parsed_file.h"

namespace galilean::bhdl::lsp {

/// What the cursor touches of the catalog's: a component's label, an attribute's, or a value.
struct Spot {
  const ComponentSpec* component = nullptr;
  const AttributeSpec* attribute = nullptr;           ///< nullptr: the component's own label
  const ValueNode* value = nullptr;                   ///< nullptr: a label
  const std::vector<AttributeNode>* given = nullptr;  ///< all attributes of that component
  ByteRange range;
};
[[nodiscard]] std::optional<Spot> spot_at(const ParsedFile& file, const Vocabulary& vocabulary,
                                          std::size_t offset);

}  // namespace galilean::bhdl::lsp
