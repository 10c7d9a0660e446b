#include "bhdl/syntax/component_parser.h"

#include "bhdl/source/text.h"
#include "bhdl/syntax/keywords.h"
#include "bhdl/syntax/value_parser.h"

namespace galilean::bhdl {
namespace {

constexpr std::size_t kUsualAttributes = 4;

bool is_over(const TokenStream& tokens, Block block) {
  if (tokens.at_end_of_file() || at_section(tokens) || tokens.at_unlabelled_block()) return true;
  switch (block) {
    case Block::kVariable:
    case Block::kStep:
      return tokens.at_bare_label();
    case Block::kCondition:
      return at_next_part_of_state(tokens);
    case Block::kComponent:
      // Only a component is followed by its name: its predecessor's `end` was forgotten.
      return tokens.at_label_before_label() && tokens.peek(2).text == "name";
  }
  return false;
}

void skip_to_word(TokenStream& tokens) {
  while (!tokens.at(TokenKind::kWord) && !tokens.at_end_of_file()) tokens.take();
}

void refuse_missing_value(TokenStream& tokens, Diagnostics& diagnostics) {
  const Word name = take_label(tokens);
  diagnostics.error(name.at, "syntax/missing-value",
                    in_quotes(name.text) + " has no value; found " + describe(tokens.peek()));
  skip_to_word(tokens);
}

}  // namespace

Word take_label(TokenStream& tokens) {
  const Token word = tokens.take();
  if (tokens.at(TokenKind::kColon)) tokens.take();
  return {word.text, word.at};
}

void report_missing_colon(const TokenStream& tokens, Diagnostics& diagnostics) {
  diagnostics.error(tokens.peek().at, "syntax/missing-colon",
                    "':' is expected after " + describe(tokens.peek()));
}

void report_unclosed(const TokenStream& tokens, const Word& opened, Diagnostics& diagnostics) {
  diagnostics.error(tokens.peek().at, "syntax/unclosed",
                    "'end' is expected before " + describe(tokens.peek()) + ": " +
                        in_quotes(opened.text) + " of line " + std::to_string(opened.at.line) +
                        " is still open");
}

void parse_attribute(TokenStream& tokens, std::vector<AttributeNode>& into,
                     Diagnostics& diagnostics) {
  if (tokens.at_bare_label()) return refuse_missing_value(tokens, diagnostics);
  if (!tokens.at(TokenKind::kWord)) {
    diagnostics.error(
        tokens.peek().at, "syntax/unexpected-token",
        "an attribute such as 'name:' or 'end' is expected, found " + describe(tokens.peek()));
    return skip_to_word(tokens);
  }
  if (!tokens.at_label()) report_missing_colon(tokens, diagnostics);
  const Word name = take_label(tokens);
  auto values = parse_values(tokens, diagnostics);
  if (!values.empty()) into.push_back({name, std::move(values)});
}

ComponentNode parse_component(TokenStream& tokens, Block block, Diagnostics& diagnostics) {
  if (!tokens.at_label()) report_missing_colon(tokens, diagnostics);
  ComponentNode component{take_label(tokens), {}};
  component.attributes.reserve(kUsualAttributes);
  while (!tokens.at_word("end")) {
    if (is_over(tokens, block)) {
      if (block != Block::kVariable) report_unclosed(tokens, component.type, diagnostics);
      return component;
    }
    parse_attribute(tokens, component.attributes, diagnostics);
  }
  take_end(tokens);
  return component;
}

}  // namespace galilean::bhdl
