// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "bhdl/check/vocabulary.h"
#include "bhdl/lsp/text_index.h"
#include "bhdl/syntax/label_sense.h"

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

/// What an editor shows as one piece: from its label to its `end`, or to where something else must
/// have closed it.
struct Block {
  BlockKind kind = BlockKind::kSection;
  std::string_view word;       ///< of its label
  std::string_view name;       ///< a component's or a state's; empty: none is given
  ComponentKind components{};  ///< of a section, and of what stands in it
  ByteRange range;
  std::optional<std::size_t> parent;  ///< among all blocks, which stand in the order of the text
};

/// What the catalog, or the language, says of a component, an expectation or one of its steps;
/// nullptr of any other block and where nothing has such a name.
[[nodiscard]] const ComponentSpec* spec_of(const Block& block, const Vocabulary& vocabulary);

/// Answers what the parser asks from the catalog.
class CatalogSense : public LabelSense {
 public:
  explicit CatalogSense(const Vocabulary& vocabulary) : vocabulary_(vocabulary) {}
  [[nodiscard]] bool is_attribute(NodeKind block, std::string_view type,
                                  std::string_view label) const override;
  [[nodiscard]] bool is_component(std::string_view label) const override;

 private:
  const Vocabulary& vocabulary_;
};

/// The block that a node is; nothing of an attribute, a value, a line or an error. `components`: of
/// the block around it.
[[nodiscard]] std::optional<Block> block_of(const ParseTree& tree, std::uint32_t node,
                                            ComponentKind components);

/// The number of the `end` that closes a node; nothing where something else does.
[[nodiscard]] std::optional<std::uint32_t> end_word(const ParseTree& tree, std::uint32_t node);

/// All blocks of a text, which need not be right.
[[nodiscard]] std::vector<Block> blocks_of(const ParseTree& tree);

}  // namespace galilean::bhdl::lsp
