// SPDX-License-Identifier: BSD-3-Clause
#include "bhdl/syntax/value_parser.h"

#include <algorithm>

#include "bhdl/source/names.h"
#include "bhdl/source/text.h"

namespace galilean::bhdl {
namespace {

// Behind a unit stands the next value's comma, a pair's bracket, an attribute or an `end`. If
// anything else follows, the word is an attribute whose colon was forgotten.
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

void refuse_unknown_unit(const Token& word, const Position& at, Diagnostics& diagnostics) {
  std::vector<std::string_view> symbols;
  std::string all = "units are";
  for (const auto& unit : all_units()) {
    if (unit.symbol.empty()) continue;
    symbols.push_back(unit.symbol);
    all.append(symbols.size() == 1 ? " " : ", ").append(unit.symbol);
  }
  const auto near = nearest(word.text, symbols);
  diagnostics.error(at, "syntax/unknown-unit", "there is no unit " + in_quotes(word.text),
                    near.empty() ? Hint(all) : did_you_mean(near));
}

/// Takes a number with its unit, if it has one. Returns whether the unit is known.
bool parse_quantity(TokenStream& tokens, Diagnostics& diagnostics) {
  const Token number = tokens.take();
  if (!at_unit(tokens, number)) return true;
  const Token word = tokens.take();
  if (known_unit(word.text) != nullptr) return true;
  refuse_unknown_unit(word, tokens.position(word), diagnostics);
  return false;
}

bool is_part_of_pair(const Token& token) {
  return token.kind == TokenKind::kNumber || token.kind == TokenKind::kComma ||
         token.kind == TokenKind::kColon;
}

ValueSense refuse_pair(TokenStream& tokens, const Token& open, std::string_view close,
                       Diagnostics& diagnostics) {
  diagnostics.error(tokens.position(), "syntax/pair",
                    "a pair is two numbers between '" + std::string(open.text) + "' and '" +
                        std::string(close) + "'; found " + describe(tokens.peek()),
                    "write it as <0, 22>");
  while (is_part_of_pair(tokens.peek())) tokens.take();
  if (tokens.at(TokenKind::kGreater) || tokens.at(TokenKind::kRightParen)) tokens.take();
  return ValueSense::kBroken;
}

ValueSense parse_pair(TokenStream& tokens, Diagnostics& diagnostics) {
  const Token open = tokens.take();
  const bool angled = open.kind == TokenKind::kLess;
  const auto close = angled ? TokenKind::kGreater : TokenKind::kRightParen;
  const std::string_view close_text = angled ? ">" : ")";
  if (!tokens.at(TokenKind::kNumber)) return refuse_pair(tokens, open, close_text, diagnostics);
  parse_quantity(tokens, diagnostics);
  if (tokens.at(TokenKind::kComma)) tokens.take();
  if (!tokens.at(TokenKind::kNumber)) return refuse_pair(tokens, open, close_text, diagnostics);
  parse_quantity(tokens, diagnostics);
  if (!tokens.at(close)) return refuse_pair(tokens, open, close_text, diagnostics);
  tokens.take();
  return ValueSense::kPair;
}

/// Takes a value. Returns whether it was a bare word.
bool parse_value(TokenStream& tokens, Diagnostics& diagnostics) {
  NodeScope value(tokens, NodeKind::kValue);
  const TokenKind kind = tokens.peek().kind;
  ValueSense sense = ValueSense::kPlain;
  if (kind == TokenKind::kNumber) {
    if (!parse_quantity(tokens, diagnostics)) sense = ValueSense::kBroken;
  } else if (kind == TokenKind::kText || kind == TokenKind::kWord) {
    tokens.take();
  } else {
    sense = parse_pair(tokens, diagnostics);
  }
  value.set_sense(static_cast<std::uint8_t>(sense));
  return kind == TokenKind::kWord;
}

}  // namespace

const Unit* known_unit(std::string_view symbol) noexcept {
  const auto units = all_units();
  const auto found = std::ranges::find(units, symbol, &Unit::symbol);
  return found == units.end() ? nullptr : &*found;
}

// `name: "a" min_sphere 30` lacks a colon. A bare word therefore continues a list only behind
// another bare word or a comma.
void parse_values(TokenStream& tokens, Diagnostics& diagnostics) {
  bool word_may_follow = true;
  while (tokens.value_at(0) && (!tokens.at(TokenKind::kWord) || word_may_follow)) {
    const bool is_word = parse_value(tokens, diagnostics);
    const bool has_comma = tokens.at(TokenKind::kComma);
    word_may_follow = is_word || has_comma;
    if (!has_comma) continue;
    const Token comma = tokens.take();
    if (!tokens.value_at(0))
      diagnostics.error(tokens.position(comma), "syntax/unexpected-token",
                        "a value is expected after ',', found " + describe(tokens.peek()));
  }
}

}  // namespace galilean::bhdl
