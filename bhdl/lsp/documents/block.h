// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "bhdl/check/vocabulary.h"
#include "bhdl/lsp/documents/text_index.h"
#include "bhdl/syntax/label_resolver.h"

namespace galilean::bhdl::lsp {

enum class BlockKind {
  kSection,
  kStates,
  kComponent,
  kState,
  kSchemaList,
  kCondition,
  kDefine,
  kOnSwap,
  kExpect,
  kExpectStep
};

/// A part that an editor shows as one piece. It reaches from its label to its `end`, or to where
/// something else must have closed it.
struct Block {
  BlockKind kind = BlockKind::kSection;
  std::string_view word;       ///< of its label
  std::string_view name;       ///< of a component or a state; empty: none is given
  ComponentKind components{};  ///< of a section, and of what stands in it
  ByteRange range;
  std::optional<std::size_t> parent;  ///< among all blocks, which stand in the order of the text
};

/// Returns what the catalog or the language says of a component, an expectation or one of its
/// steps. Returns nullptr for any other block, and if nothing has such a name.
[[nodiscard]] const ComponentSpec* spec_of(const Block& block, const Vocabulary& vocabulary);

/// Answers the parser's questions from the catalog.
class CatalogLabelResolver : public LabelResolver {
 public:
  explicit CatalogLabelResolver(const Vocabulary& vocabulary) : vocabulary_(vocabulary) {}
  [[nodiscard]] bool is_attribute(NodeKind block, std::string_view type,
                                  std::string_view label) const override;
  [[nodiscard]] bool is_component(std::string_view label) const override;

 private:
  const Vocabulary& vocabulary_;
};

/// Returns the block that a node is, or nothing for an attribute, a value, a line or an error.
/// `components` is that of the block around it.
[[nodiscard]] std::optional<Block> block_of(const ParseTree& tree, std::uint32_t node,
                                            ComponentKind components);

/// Returns the number of the `end` that closes a node, or nothing if something else closes it.
[[nodiscard]] std::optional<std::uint32_t> end_word(const ParseTree& tree, std::uint32_t node);

/// Returns all blocks of a text, which may have mistakes.
[[nodiscard]] std::vector<Block> blocks_of(const ParseTree& tree);

}  // namespace galilean::bhdl::lsp
