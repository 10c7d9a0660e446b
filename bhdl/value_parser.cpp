#include "bhdl/value_parser.h"

namespace galilean::bhdl {
namespace {

ValueNode plain(ValueNode::Kind kind, const Token& token) {
  return {kind, token.number, 0, token.text, token.at};
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

ValueNode parse_pair(TokenStream& tokens, Diagnostics& diagnostics) {
  const Token open = tokens.take();
  const bool angled = open.kind == TokenKind::kLess;
  const auto close = angled ? TokenKind::kGreater : TokenKind::kRightParen;
  const std::string_view close_text = angled ? ">" : ")";
  ValueNode pair{ValueNode::Kind::kPair, 0, 0, open.text, open.at};
  if (!tokens.at(TokenKind::kNumber)) return refuse_pair(tokens, open, close_text, diagnostics);
  pair.number = tokens.take().number;
  if (tokens.at(TokenKind::kComma)) tokens.take();
  if (!tokens.at(TokenKind::kNumber)) return refuse_pair(tokens, open, close_text, diagnostics);
  pair.second = tokens.take().number;
  if (!tokens.at(close)) return refuse_pair(tokens, open, close_text, diagnostics);
  tokens.take();
  return pair;
}

ValueNode parse_value(TokenStream& tokens, Diagnostics& diagnostics) {
  switch (tokens.peek().kind) {
    case TokenKind::kNumber:
      return plain(ValueNode::Kind::kNumber, tokens.take());
    case TokenKind::kText:
      return plain(ValueNode::Kind::kText, tokens.take());
    case TokenKind::kWord:
      return plain(ValueNode::Kind::kBareWord, tokens.take());
    default:
      return parse_pair(tokens, diagnostics);
  }
}

// `name: "a" min_sphere 30` lacks a colon: a bare word goes on a list of bare words alone.
bool goes_on(const TokenStream& tokens, const std::vector<ValueNode>& values) {
  if (!tokens.value_at(0)) return false;
  return !tokens.at(TokenKind::kWord) || values.empty() ||
         values.back().kind == ValueNode::Kind::kBareWord;
}

}  // namespace

std::vector<ValueNode> parse_values(TokenStream& tokens, Diagnostics& diagnostics) {
  std::vector<ValueNode> values;
  while (goes_on(tokens, values)) {
    values.push_back(parse_value(tokens, diagnostics));
    if (!tokens.at(TokenKind::kComma)) continue;
    const Token comma = tokens.take();
    if (!tokens.value_at(0))
      diagnostics.error(comma.at, "syntax/unexpected-token",
                        "a value is expected after ',', found " + describe(tokens.peek()));
  }
  return values;
}

}  // namespace galilean::bhdl
