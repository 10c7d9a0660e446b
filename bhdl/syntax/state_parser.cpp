// SPDX-License-Identifier: BSD-3-Clause
#include "bhdl/syntax/state_parser.h"

#include <array>

#include "bhdl/source/names.h"
#include "bhdl/source/text.h"
#include "bhdl/syntax/component_parser.h"
#include "bhdl/syntax/keywords.h"
#include "bhdl/syntax/value_parser.h"

namespace galilean::bhdl {
namespace {

constexpr std::array<std::string_view, 3> kParts{"perceptual_schemas", "motor_schemas",
                                                 "condition"};

// `kind` is what the list's schemas are, whatever word it has.
void parse_schema_list(TokenStream& tokens, ComponentKind kind, Diagnostics& diagnostics) {
  const NodeScope list(tokens, NodeKind::kSchemaList, static_cast<std::uint8_t>(kind));
  const Token name = take_label(tokens);
  parse_values(tokens, diagnostics);
  if (tokens.at_word("end"))
    take_end(tokens);
  else
    report_unclosed(tokens, name, diagnostics);
}

// A misspelt list must still be read as a list, because its `end` would close the state otherwise.
std::string meant_part(const TokenStream& tokens) {
  if (!tokens.at_label() || tokens.peek().text == "name") return {};
  const auto part = nearest(tokens.peek().text, kParts);
  return part == "condition" && tokens.value_at(2) ? std::string() : part;
}

void parse_misspelt_part(TokenStream& tokens, const std::string& part, Diagnostics& diagnostics) {
  diagnostics.error(tokens.position(), "syntax/unknown-word",
                    in_quotes(tokens.peek().text) + " is no part of a state", did_you_mean(part));
  if (part == "condition")
    parse_component(tokens, Block::kCondition, diagnostics);
  else
    parse_schema_list(tokens, *section_kind(part), diagnostics);
}

void parse_part(TokenStream& tokens, Diagnostics& diagnostics) {
  if (tokens.at_label("condition"))
    parse_component(tokens, Block::kCondition, diagnostics);
  else if (at_schema_list(tokens))
    parse_schema_list(tokens, *section_kind(tokens.peek().text), diagnostics);
  else if (const auto part = meant_part(tokens); !part.empty())
    parse_misspelt_part(tokens, part, diagnostics);
  else
    parse_attribute(tokens, diagnostics);
}

}  // namespace

void parse_state(TokenStream& tokens, Diagnostics& diagnostics) {
  const NodeScope state(tokens, NodeKind::kState);
  const Token keyword = take_label(tokens);
  while (!tokens.at_word("end")) {
    const bool over = tokens.at_end_of_file() || (at_section(tokens) && !at_schema_list(tokens));
    if (over) return report_unclosed(tokens, keyword, diagnostics);
    parse_part(tokens, diagnostics);
  }
  take_end(tokens);
}

}  // namespace galilean::bhdl
