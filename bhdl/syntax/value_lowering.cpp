// SPDX-License-Identifier: BSD-3-Clause
#include "bhdl/syntax/value_lowering.h"

#include "bhdl/syntax/value_parser.h"

namespace galilean::bhdl {
namespace {

using Kind = ValueNode::Kind;

/// A number as it is written. `end` is the index of the token behind it.
struct Quantity {
  double number = 0;
  const Unit* unit = nullptr;
  bool readable = true;  ///< its unit is known, or it has none
  std::uint32_t end = 0;
};

// A word behind a number in a value is always its unit.
Quantity quantity_at(const ParseTree& tree, std::uint32_t token, std::uint32_t end_of_value) {
  Quantity quantity{tree.tokens[token].number, nullptr, true, token + 1};
  const bool has_unit =
      quantity.end < end_of_value && tree.tokens[quantity.end].kind == TokenKind::kWord;
  if (!has_unit) return quantity;
  quantity.unit = known_unit(tree.tokens[quantity.end++].text);
  quantity.readable = quantity.unit != nullptr;
  return quantity;
}

ValueNode number_of(const ParseTree& tree, const Node& node, ValueNode value) {
  const Quantity quantity = quantity_at(tree, node.first_token, node.end_token);
  value.kind = quantity.readable ? Kind::kNumber : Kind::kBroken;
  value.number = quantity.number;
  value.unit = quantity.unit;
  return value;
}

ValueNode pair_of(const ParseTree& tree, const Node& node, ValueNode value) {
  const Quantity first = quantity_at(tree, node.first_token + 1, node.end_token);
  const bool has_comma = tree.tokens[first.end].kind == TokenKind::kComma;
  const Quantity second = quantity_at(tree, first.end + (has_comma ? 1 : 0), node.end_token);
  value.kind = first.readable && second.readable ? Kind::kPair : Kind::kBroken;
  value.number = first.number;
  value.second = second.number;
  value.unit = first.unit != nullptr ? first.unit : second.unit;
  value.second_unit = second.unit != nullptr ? second.unit : first.unit;
  return value;
}

}  // namespace

ValueNode lowered_value(const ParseTree& tree, const Node& node, std::string_view file) {
  const Token& first = tree.first_token(node);
  ValueNode value;
  value.text = first.text;
  value.at = {file, first.at.line, first.at.column};
  switch (first.kind) {
    case TokenKind::kNumber:
      return number_of(tree, node, value);
    case TokenKind::kText:
      value.kind = Kind::kText;
      return value;
    case TokenKind::kWord:
      value.kind = Kind::kBareWord;
      return value;
    default:
      value.kind = Kind::kBroken;
      return ValueSense{node.sense} == ValueSense::kPair ? pair_of(tree, node, value) : value;
  }
}

}  // namespace galilean::bhdl
