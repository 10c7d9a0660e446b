#include "bhdl/syntax/value_parser.h"

#include <algorithm>

#include "bhdl/source/names.h"
#include "bhdl/source/text.h"

namespace galilean::bhdl {
namespace {

constexpr std::size_t kUsualList = 8;

/// A number as it is written. `readable` is false where its unit is none.
struct Quantity {
  Token number;
  const Unit* unit = nullptr;
  bool readable = true;
};

ValueNode plain(ValueNode::Kind kind, const Token& token) {
  return {kind, token.number, 0, token.text, token.at};
}

const Unit* known_unit(std::string_view symbol) {
  const auto units = all_units();
  const auto found = std::ranges::find(units, symbol, &Unit::symbol);
  return found == units.end() ? nullptr : &*found;
}

// What follows a unit: the next value's comma, a pair's bracket, an attribute or an `end`. A word
// before anything else is rather an attribute whose colon was forgotten.
bool unit_may_end_at(const TokenStream& tokens, std::size_t ahead) {
  const Token& token = tokens.peek(ahead);
  switch (token.kind) {
    case TokenKind::kComma:
    case TokenKind::kGreater:
    case TokenKind::kRightParen:
    case TokenKind::kEndOfFile:
      return true;
    case TokenKind::kWord:
      return token.text == "end" ||
             (token.text != "name" && tokens.peek(ahead + 1).kind == TokenKind::kColon);
    default:
      return false;
  }
}

bool at_unit(const TokenStream& tokens, const Token& number) {
  const Token& word = tokens.peek();
  if (word.kind != TokenKind::kWord || word.text == "end") return false;
  if (tokens.peek(1).kind == TokenKind::kColon) return false;
  const bool touches = number.text.data() + number.text.size() == word.text.data();
  return touches || known_unit(word.text) != nullptr || unit_may_end_at(tokens, 1);
}

void refuse_unknown_unit(const Token& word, Diagnostics& diagnostics) {
  std::vector<std::string_view> symbols;
  std::string all = "units are";
  for (const auto& unit : all_units()) {
    if (unit.symbol.empty()) continue;
    symbols.push_back(unit.symbol);
    all.append(symbols.size() == 1 ? " " : ", ").append(unit.symbol);
  }
  const auto near = nearest(word.text, symbols);
  diagnostics.error(word.at, "syntax/unknown-unit", "there is no unit " + in_quotes(word.text),
                    near.empty() ? Hint(all) : did_you_mean(near));
}

Quantity parse_quantity(TokenStream& tokens, Diagnostics& diagnostics) {
  Quantity quantity{tokens.take()};
  if (!at_unit(tokens, quantity.number)) return quantity;
  const Token word = tokens.take();
  quantity.unit = known_unit(word.text);
  quantity.readable = quantity.unit != nullptr;
  if (!quantity.readable) refuse_unknown_unit(word, diagnostics);
  return quantity;
}

ValueNode parse_number(TokenStream& tokens, Diagnostics& diagnostics) {
  const Quantity quantity = parse_quantity(tokens, diagnostics);
  using enum ValueNode::Kind;
  ValueNode value = plain(quantity.readable ? kNumber : kBroken, quantity.number);
  value.unit = quantity.unit;
  return value;
}

bool is_part_of_pair(const Token& token) {
  return token.kind == TokenKind::kNumber || token.kind == TokenKind::kComma ||
         token.kind == TokenKind::kColon;
}

ValueNode refuse_pair(TokenStream& tokens, const Token& open, std::string_view close,
                      Diagnostics& diagnostics) {
  diagnostics.error(tokens.peek().at, "syntax/pair",
                    "a pair is two numbers between '" + std::string(open.text) + "' and '" +
                        std::string(close) + "'; found " + describe(tokens.peek()),
                    "write it as <0, 22>");
  while (is_part_of_pair(tokens.peek())) tokens.take();
  if (tokens.at(TokenKind::kGreater) || tokens.at(TokenKind::kRightParen)) tokens.take();
  return {ValueNode::Kind::kBroken, 0, 0, open.text, open.at};
}

ValueNode pair_of(const Token& open, const Quantity& first, const Quantity& second) {
  const bool readable = first.readable && second.readable;
  ValueNode pair{readable ? ValueNode::Kind::kPair : ValueNode::Kind::kBroken, first.number.number,
                 second.number.number, open.text, open.at};
  pair.unit = first.unit != nullptr ? first.unit : second.unit;
  pair.second_unit = second.unit != nullptr ? second.unit : first.unit;
  return pair;
}

ValueNode parse_pair(TokenStream& tokens, Diagnostics& diagnostics) {
  const Token open = tokens.take();
  const bool angled = open.kind == TokenKind::kLess;
  const auto close = angled ? TokenKind::kGreater : TokenKind::kRightParen;
  const std::string_view close_text = angled ? ">" : ")";
  if (!tokens.at(TokenKind::kNumber)) return refuse_pair(tokens, open, close_text, diagnostics);
  const Quantity first = parse_quantity(tokens, diagnostics);
  if (tokens.at(TokenKind::kComma)) tokens.take();
  if (!tokens.at(TokenKind::kNumber)) return refuse_pair(tokens, open, close_text, diagnostics);
  const Quantity second = parse_quantity(tokens, diagnostics);
  if (!tokens.at(close)) return refuse_pair(tokens, open, close_text, diagnostics);
  tokens.take();
  return pair_of(open, first, second);
}

ValueNode parse_value(TokenStream& tokens, Diagnostics& diagnostics) {
  switch (tokens.peek().kind) {
    case TokenKind::kNumber:
      return parse_number(tokens, diagnostics);
    case TokenKind::kText:
      return plain(ValueNode::Kind::kText, tokens.take());
    case TokenKind::kWord:
      return plain(ValueNode::Kind::kBareWord, tokens.take());
    default:
      return parse_pair(tokens, diagnostics);
  }
}

// `name: "a" min_sphere 30` lacks a colon: a bare word goes on a list of bare words alone, or
// behind a comma.
bool goes_on(const TokenStream& tokens, const std::vector<ValueNode>& values, bool after_comma) {
  if (!tokens.value_at(0)) return false;
  return !tokens.at(TokenKind::kWord) || values.empty() || after_comma ||
         values.back().kind == ValueNode::Kind::kBareWord;
}

}  // namespace

std::vector<ValueNode> parse_values(TokenStream& tokens, Diagnostics& diagnostics) {
  std::vector<ValueNode> values;
  if (tokens.peek(1).kind == TokenKind::kText) values.reserve(kUsualList);
  bool after_comma = false;
  while (goes_on(tokens, values, after_comma)) {
    values.push_back(parse_value(tokens, diagnostics));
    after_comma = tokens.at(TokenKind::kComma);
    if (!after_comma) continue;
    const Token comma = tokens.take();
    if (!tokens.value_at(0))
      diagnostics.error(comma.at, "syntax/unexpected-token",
                        "a value is expected after ',', found " + describe(tokens.peek()));
  }
  return values;
}

}  // namespace galilean::bhdl
