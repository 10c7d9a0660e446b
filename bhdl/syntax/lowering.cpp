// SPDX-License-Identifier: BSD-3-Clause
#include "bhdl/syntax/lowering.h"

#include <algorithm>

#include "bhdl/syntax/keywords.h"
#include "bhdl/syntax/value_lowering.h"

namespace galilean::bhdl {
namespace {

class Lowering {
 public:
  Lowering(SyntaxTree& result, const ParseTree& tree, std::string_view file)
      : result_(result), tree_(tree), file_(file) {}

  void run() { add_all(tree_.roots()); }

 private:
  // The checker treats bare states and those in `states:` alike. The recursion ends there.
  void add_all(const NodeRange& nodes) {
    for (const auto node : nodes) add(node);
  }

  void add(std::uint32_t i) {
    switch (tree_.nodes[i].kind) {
      case NodeKind::kSection:
        result_.emplace_back(section(i));
        break;
      case NodeKind::kStates:
      case NodeKind::kOnSwap:
        add_all(tree_.children(i));
        break;
      case NodeKind::kState:
        result_.emplace_back(state(i));
        break;
      case NodeKind::kDefine:
        result_.emplace_back(DefineNode{attributes(i)});
        break;
      case NodeKind::kExpect:
        result_.emplace_back(ExpectNode{keyword(i), attributes(i), components(i, NodeKind::kStep)});
        break;
      default:
        add_line(tree_.nodes[i]);
    }
  }

  // The parser has reported an incomplete line. It adds nothing to the tree.
  void add_line(const Node& line) {
    const Token& last = tree_.tokens[line.end_token - 1];
    if (last.kind != TokenKind::kText) return;
    if (line.kind == NodeKind::kInclude) result_.emplace_back(IncludeNode{word(last)});
    if (line.kind == NodeKind::kStartState) result_.emplace_back(StartStateNode{word(last)});
    if (line.kind == NodeKind::kSwap && line.end_token - line.first_token == 3)
      result_.emplace_back(SwapNode{word(tree_.first_token(line)), word(last)});
  }

  [[nodiscard]] SectionNode section(std::uint32_t i) const {
    return {keyword(i), static_cast<ComponentKind>(tree_.nodes[i].sense),
            components(i, NodeKind::kComponent)};
  }

  [[nodiscard]] StateNode state(std::uint32_t i) const {
    return {keyword(i), attributes(i), components(i, NodeKind::kCondition)};
  }

  [[nodiscard]] std::vector<ComponentNode> components(std::uint32_t block, NodeKind kind) const {
    const auto is_one = [&](std::uint32_t i) { return tree_.nodes[i].kind == kind; };
    std::vector<ComponentNode> all;
    all.reserve(count(tree_.children(block), is_one));
    for (const auto i : tree_.children(block))
      if (is_one(i)) all.push_back({keyword(i), attributes(i)});
    return all;
  }

  /// Returns a block's attributes, and a state's lists among them.
  [[nodiscard]] std::vector<AttributeNode> attributes(std::uint32_t block) const {
    const auto is_given = [&](std::uint32_t i) {
      const NodeKind kind = tree_.nodes[i].kind;
      const bool has_value = tree_.nodes[i].end_node > i + 1;
      return (kind == NodeKind::kAttribute && has_value) || kind == NodeKind::kSchemaList;
    };
    std::vector<AttributeNode> all;
    all.reserve(count(tree_.children(block), is_given));
    for (const auto i : tree_.children(block))
      if (is_given(i)) all.push_back({label(i), values(i)});
    return all;
  }

  [[nodiscard]] std::vector<ValueNode> values(std::uint32_t attribute) const {
    std::vector<ValueNode> all;
    all.reserve(count(tree_.children(attribute)));
    for (const auto i : tree_.children(attribute))
      all.push_back(lowered_value(tree_, tree_.nodes[i], file_));
    return all;
  }

  // A misspelt list gets the name that was meant.
  [[nodiscard]] Word label(std::uint32_t i) const {
    Word name = keyword(i);
    if (tree_.nodes[i].kind != NodeKind::kSchemaList || section_kind(name.text)) return name;
    name.text = section_word(static_cast<ComponentKind>(tree_.nodes[i].sense));
    return name;
  }

  [[nodiscard]] Word keyword(std::uint32_t i) const {
    return word(tree_.first_token(tree_.nodes[i]));
  }
  [[nodiscard]] Word word(const Token& token) const {
    return {token.text, {file_, token.at.line, token.at.column}};
  }

  template <class Counts>
  [[nodiscard]] static std::size_t count(const NodeRange& nodes, Counts counts) {
    std::size_t found = 0;
    for (const auto i : nodes) found += counts(i) ? 1 : 0;
    return found;
  }
  [[nodiscard]] static std::size_t count(const NodeRange& nodes) {
    return count(nodes, [](std::uint32_t) { return true; });
  }

  SyntaxTree& result_;
  const ParseTree& tree_;
  std::string_view file_;
};

}  // namespace

void lower_into(SyntaxTree& result, const ParseTree& tree, std::string_view file) {
  Lowering(result, tree, file).run();
}

std::vector<std::string_view> includes_of(const ParseTree& tree) {
  std::vector<std::string_view> paths;
  for (const auto root : tree.roots()) {
    const Node& node = tree.nodes[root];
    const Token& last = tree.tokens[node.end_token - 1];
    if (node.kind == NodeKind::kInclude && last.kind == TokenKind::kText)
      paths.push_back(last.text);
  }
  return paths;
}

SyntaxTree lowered(const ParseTree& tree, std::string_view file) {
  SyntaxTree result;
  lower_into(result, tree, file);
  return result;
}

}  // namespace galilean::bhdl
