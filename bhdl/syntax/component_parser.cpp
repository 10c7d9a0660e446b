// SPDX-License-Identifier: BSD-3-Clause
#include "bhdl/syntax/component_parser.h"

#include "bhdl/source/text.h"
#include "bhdl/syntax/keywords.h"
#include "bhdl/syntax/value_parser.h"

namespace galilean::bhdl {
namespace {

NodeKind node_kind(Block block) {
  if (block == Block::kCondition) return NodeKind::kCondition;
  return block == Block::kStep ? NodeKind::kStep : NodeKind::kComponent;
}

// Only a component is followed by its name. If one follows here, the `end` before it was forgotten.
bool at_next_component(const TokenStream& tokens) {
  return tokens.at_label_before_label() && tokens.peek(2).text == "name";
}

// A section's word may also be an attribute of this component that is being typed.
bool at_next_section(const TokenStream& tokens, bool known) {
  return at_section(tokens) && !(known && tokens.text_ends_at_label());
}

bool is_over(const TokenStream& tokens, Block block, std::string_view type) {
  if (tokens.at_end_of_file() || tokens.at_unlabelled_block()) return true;
  const bool known = tokens.at_known_attribute(node_kind(block), type);
  if (at_next_section(tokens, known)) return true;
  switch (block) {
    case Block::kVariable:
      return at_next_component(tokens) || (tokens.at_bare_label() && !known);
    case Block::kStep:
      return tokens.at_bare_label() && !known;
    case Block::kCondition:
      return at_next_part_of_state(tokens);
    case Block::kComponent:
      return at_next_component(tokens) || (tokens.at_known_component() && !known);
  }
  return false;
}

void skip_to_word(TokenStream& tokens) {
  if (tokens.at(TokenKind::kWord) || tokens.at_end_of_file()) return;
  const NodeScope skipped(tokens, NodeKind::kError);
  while (!tokens.at(TokenKind::kWord) && !tokens.at_end_of_file()) tokens.take();
}

void refuse_missing_value(TokenStream& tokens, Diagnostics& diagnostics) {
  {
    const NodeScope attribute(tokens, NodeKind::kAttribute);
    const Token name = take_label(tokens);
    diagnostics.error(tokens.position(name), "syntax/missing-value",
                      in_quotes(name.text) + " has no value; found " + describe(tokens.peek()));
  }
  skip_to_word(tokens);
}

}  // namespace

Token take_label(TokenStream& tokens) {
  const Token word = tokens.take();
  if (tokens.at(TokenKind::kColon)) tokens.take();
  return word;
}

void report_missing_colon(const TokenStream& tokens, Diagnostics& diagnostics) {
  diagnostics.error(tokens.position(), "syntax/missing-colon",
                    "':' is expected after " + describe(tokens.peek()));
}

void report_unclosed(const TokenStream& tokens, const Token& opened, Diagnostics& diagnostics) {
  diagnostics.error(tokens.position(), "syntax/unclosed",
                    "'end' is expected before " + describe(tokens.peek()) + ": " +
                        in_quotes(opened.text) + " of line " + std::to_string(opened.at.line) +
                        " is still open");
}

void parse_attribute(TokenStream& tokens, Diagnostics& diagnostics) {
  if (tokens.at_bare_label()) return refuse_missing_value(tokens, diagnostics);
  if (!tokens.at(TokenKind::kWord)) {
    diagnostics.error(
        tokens.position(), "syntax/unexpected-token",
        "an attribute such as 'name:' or 'end' is expected, found " + describe(tokens.peek()));
    return skip_to_word(tokens);
  }
  if (!tokens.at_label()) report_missing_colon(tokens, diagnostics);
  const NodeScope attribute(tokens, NodeKind::kAttribute);
  take_label(tokens);
  parse_values(tokens, diagnostics);
}

void parse_component(TokenStream& tokens, Block block, Diagnostics& diagnostics) {
  if (!tokens.at_label()) report_missing_colon(tokens, diagnostics);
  const NodeScope component(tokens, node_kind(block));
  const Token type = take_label(tokens);
  while (!tokens.at_word("end")) {
    if (is_over(tokens, block, type.text)) {
      if (block != Block::kVariable) report_unclosed(tokens, type, diagnostics);
      return;
    }
    parse_attribute(tokens, diagnostics);
  }
  take_end(tokens);
}

}  // namespace galilean::bhdl
