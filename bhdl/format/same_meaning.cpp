// SPDX-License-Identifier: BSD-3-Clause
#include "bhdl/format/same_meaning.h"

#include <algorithm>

#include "bhdl/syntax/keywords.h"

namespace galilean::bhdl {
namespace {

bool same(const Word& a, const Word& b) {
  const auto kind = section_kind(a.text);
  return a.text == b.text || (kind && kind == section_kind(b.text));
}

bool same(const ValueNode& a, const ValueNode& b) {
  if (a.kind != b.kind || a.number != b.number || a.second != b.second) return false;
  if (a.unit != b.unit || a.second_unit != b.second_unit) return false;
  const bool is_word = a.kind == ValueNode::Kind::kText || a.kind == ValueNode::Kind::kBareWord;
  return !is_word || a.text == b.text;
}

bool same(const AttributeNode& a, const AttributeNode& b);
bool same(const ComponentNode& a, const ComponentNode& b);

template <class Node>
bool all_same(const std::vector<Node>& a, const std::vector<Node>& b) {
  return std::ranges::equal(a, b, [](const Node& x, const Node& y) { return same(x, y); });
}

bool same(const AttributeNode& a, const AttributeNode& b) {
  return same(a.name, b.name) && all_same(a.values, b.values);
}

bool same(const ComponentNode& a, const ComponentNode& b) {
  return same(a.type, b.type) && all_same(a.attributes, b.attributes);
}

bool same(const SectionNode& a, const SectionNode& b) {
  return a.kind == b.kind && all_same(a.components, b.components);
}

bool same(const StateNode& a, const StateNode& b) {
  return all_same(a.attributes, b.attributes) && all_same(a.conditions, b.conditions);
}

bool same(const DefineNode& a, const DefineNode& b) {
  return all_same(a.constants, b.constants);
}

bool same(const IncludeNode& a, const IncludeNode& b) {
  return a.path.text == b.path.text;
}

bool same(const StartStateNode& a, const StartStateNode& b) {
  return a.state.text == b.state.text;
}

bool same(const SwapNode& a, const SwapNode& b) {
  return a.old_state.text == b.old_state.text && a.new_state.text == b.new_state.text;
}

bool same(const ExpectNode& a, const ExpectNode& b) {
  return all_same(a.attributes, b.attributes) && all_same(a.steps, b.steps);
}

bool same_node(const SyntaxNode& a, const SyntaxNode& b) {
  return a.index() == b.index() && std::visit(
                                       [&b](const auto& node) {
                                         using Node = std::decay_t<decltype(node)>;
                                         return same(node, std::get<Node>(b));
                                       },
                                       a);
}

}  // namespace

bool same_meaning(const SyntaxTree& a, const SyntaxTree& b) {
  return std::ranges::equal(a, b, same_node);
}

}  // namespace galilean::bhdl
