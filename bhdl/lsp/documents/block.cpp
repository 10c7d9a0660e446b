// SPDX-License-Identifier: BSD-3-Clause
#include "bhdl/lsp/documents/block.h"

#include <algorithm>

#include "bhdl/check/expectation_specs.h"

namespace galilean::bhdl::lsp {
namespace {

std::optional<BlockKind> block_kind(NodeKind kind) {
  switch (kind) {
    case NodeKind::kSection:
      return BlockKind::kSection;
    case NodeKind::kStates:
      return BlockKind::kStates;
    case NodeKind::kComponent:
      return BlockKind::kComponent;
    case NodeKind::kState:
      return BlockKind::kState;
    case NodeKind::kSchemaList:
      return BlockKind::kSchemaList;
    case NodeKind::kCondition:
      return BlockKind::kCondition;
    case NodeKind::kDefine:
      return BlockKind::kDefine;
    case NodeKind::kOnSwap:
      return BlockKind::kOnSwap;
    case NodeKind::kExpect:
      return BlockKind::kExpect;
    case NodeKind::kStep:
      return BlockKind::kExpectStep;
    default:
      return std::nullopt;
  }
}

const ComponentSpec* find_step(std::string_view word) {
  const auto steps = step_specs();
  const auto found = std::ranges::find(steps, word, &ComponentSpec::name);
  return found == steps.end() ? nullptr : &*found;
}

std::string_view name_in(const ParseTree& tree, std::uint32_t block) {
  std::string_view name;
  for (const auto i : tree.children(block)) {
    const Node& attribute = tree.nodes[i];
    if (attribute.kind != NodeKind::kAttribute || tree.first_token(attribute).text != "name")
      continue;
    for (auto token = attribute.first_token; token < attribute.end_token; ++token)
      if (tree.tokens[token].kind == TokenKind::kText) name = tree.tokens[token].text;
  }
  return name;
}

std::size_t end_of(const ParseTree& tree, std::uint32_t end_token) {
  const std::string_view last = tree.tokens[end_token - 1].text;
  return tree.offset_of(last) + last.size();
}

std::uint32_t end_of_parts(const ParseTree& tree, std::uint32_t node) {
  std::uint32_t end = tree.nodes[node].first_token + 1;
  for (const auto part : tree.children(node)) end = tree.nodes[part].end_token;
  return end;
}

class BlockFinder {
 public:
  explicit BlockFinder(const ParseTree& tree) : tree_(tree) {}

  std::vector<Block> run() {
    add(tree_.roots(), std::nullopt, {});
    return std::move(blocks_);
  }

 private:
  // The recursion is only as deep as the grammar: sections, states, conditions.
  void add(const NodeRange& nodes, std::optional<std::size_t> parent, ComponentKind components) {
    for (const auto node : nodes) {
      auto block = block_of(tree_, node, components);
      if (!block) continue;
      block->parent = parent;
      const std::size_t number = blocks_.size();
      blocks_.push_back(*block);
      add(tree_.children(node), number, block->components);
      if (block->kind == BlockKind::kSection) take_end_of_last(node);
    }
  }

  // A variable needs no `end`. The `end` behind a section's last variable belongs to the section.
  void take_end_of_last(std::uint32_t section) {
    if (blocks_.back().kind != BlockKind::kComponent || end_word(tree_, section)) return;
    if (blocks_.back().components != ComponentKind::kVariable) return;
    std::uint32_t last = section;
    for (const auto component : tree_.children(section)) last = component;
    if (const auto end = end_word(tree_, last)) blocks_.back().range.end = end_of(tree_, *end);
  }

  const ParseTree& tree_;
  std::vector<Block> blocks_;
};

}  // namespace

const ComponentSpec* spec_of(const Block& block, const Vocabulary& vocabulary) {
  if (block.kind == BlockKind::kComponent) return vocabulary.find(block.word);
  if (block.kind == BlockKind::kExpectStep) return find_step(block.word);
  return block.kind == BlockKind::kExpect ? &expect_spec() : nullptr;
}

bool CatalogLabelResolver::is_attribute(NodeKind block, std::string_view type,
                                        std::string_view label) const {
  Block of;
  of.kind = block_kind(block).value_or(BlockKind::kSection);
  of.word = type;
  const ComponentSpec* spec = spec_of(of, vocabulary_);
  return spec != nullptr && spec->find(label) != nullptr;
}

bool CatalogLabelResolver::is_component(std::string_view label) const {
  return vocabulary_.find(label) != nullptr;
}

std::optional<Block> block_of(const ParseTree& tree, std::uint32_t node, ComponentKind components) {
  const Node& at = tree.nodes[node];
  const auto kind = block_kind(at.kind);
  if (!kind) return std::nullopt;
  Block block;
  block.kind = *kind;
  block.word = tree.first_token(at).text;
  block.name = name_in(tree, node);
  block.components =
      *kind == BlockKind::kSection ? static_cast<ComponentKind>(at.sense) : components;
  block.range = {tree.offset_of(block.word), end_of(tree, at.end_token)};
  return block;
}

std::optional<std::uint32_t> end_word(const ParseTree& tree, std::uint32_t node) {
  const std::uint32_t parts = end_of_parts(tree, node);
  std::uint32_t last = tree.nodes[node].end_token - 1;
  if (last > parts && tree.tokens[last].kind == TokenKind::kColon) --last;
  const bool is_end = last >= parts && tree.tokens[last].kind == TokenKind::kWord &&
                      tree.tokens[last].text == "end";
  return is_end ? std::optional(last) : std::nullopt;
}

std::vector<Block> blocks_of(const ParseTree& tree) {
  return BlockFinder(tree).run();
}

}  // namespace galilean::bhdl::lsp
