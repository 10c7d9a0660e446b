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

AttributeNode parse_schema_list(TokenStream& tokens, Diagnostics& diagnostics) {
  AttributeNode list{take_label(tokens), {}};
  list.values = parse_values(tokens, diagnostics);
  if (tokens.at_word("end"))
    take_end(tokens);
  else
    report_unclosed(tokens, list.name, diagnostics);
  return list;
}

// A misspelt list must be read as a list all the same: its `end` would close the state.
std::string meant_part(const TokenStream& tokens) {
  if (!tokens.at_label() || tokens.peek().text == "name") return {};
  const auto part = nearest(tokens.peek().text, kParts);
  return part == "condition" && tokens.value_at(2) ? std::string() : part;
}

void parse_misspelt_part(TokenStream& tokens, const std::string& part, StateNode& state,
                         Diagnostics& diagnostics) {
  diagnostics.error(tokens.peek().at, "syntax/unknown-word",
                    in_quotes(tokens.peek().text) + " is no part of a state", did_you_mean(part));
  if (part == "condition") {
    state.conditions.push_back(parse_component(tokens, Block::kCondition, diagnostics));
    return;
  }
  AttributeNode list = parse_schema_list(tokens, diagnostics);
  list.name.text = *std::ranges::find(kParts, part);
  state.attributes.push_back(std::move(list));
}

void parse_part(TokenStream& tokens, StateNode& state, Diagnostics& diagnostics) {
  if (tokens.at_label("condition"))
    state.conditions.push_back(parse_component(tokens, Block::kCondition, diagnostics));
  else if (at_schema_list(tokens))
    state.attributes.push_back(parse_schema_list(tokens, diagnostics));
  else if (const auto part = meant_part(tokens); !part.empty())
    parse_misspelt_part(tokens, part, state, diagnostics);
  else
    parse_attribute(tokens, state.attributes, diagnostics);
}

}  // namespace

StateNode parse_state(TokenStream& tokens, Diagnostics& diagnostics) {
  StateNode state{take_label(tokens), {}, {}};
  while (!tokens.at_word("end")) {
    const bool over = tokens.at_end_of_file() || (at_section(tokens) && !at_schema_list(tokens));
    if (over) {
      report_unclosed(tokens, state.keyword, diagnostics);
      return state;
    }
    parse_part(tokens, state, diagnostics);
  }
  take_end(tokens);
  return state;
}

}  // namespace galilean::bhdl
