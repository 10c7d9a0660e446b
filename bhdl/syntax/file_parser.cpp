// SPDX-License-Identifier: BSD-3-Clause
#include "bhdl/syntax/file_parser.h"

#include "bhdl/source/names.h"
#include "bhdl/source/text.h"
#include "bhdl/syntax/component_parser.h"
#include "bhdl/syntax/expectation_parser.h"
#include "bhdl/syntax/keywords.h"
#include "bhdl/syntax/state_parser.h"

namespace galilean::bhdl {

void FileParser::parse() {
  while (!done()) item();
}

void FileParser::item() {
  if (states_)
    item_of_states();
  else
    item_outside();
  if (states_) tokens_.close(*states_);
}

void FileParser::forget() {
  tokens_.forget();
  if (states_) states_ = tokens_.open(NodeKind::kStates);
}

void FileParser::item_outside() {
  if (at_section_word(tokens_)) return section(tokens_.peek().text);
  refuse_outside();
}

void FileParser::section(std::string_view word) {
  if (const auto kind = section_kind(word)) return components(*kind);
  if (word == "states") return states();
  if (word == "state") return parse_state(tokens_, diagnostics_);
  if (word == "define") return define();
  if (word == "expect") return parse_expectation(tokens_, diagnostics_);
  if (word == "include") return include();
  if (word == "start_state") return start_state();
  on_swap();
}

void FileParser::components(ComponentKind kind) {
  const NodeScope section(tokens_, NodeKind::kSection, static_cast<std::uint8_t>(kind));
  take_label(tokens_);
  const auto block = kind == ComponentKind::kVariable ? Block::kVariable : Block::kComponent;
  while (!section_is_over()) {
    if (tokens_.at_bare_label() || tokens_.at_unlabelled_block())
      parse_component(tokens_, block, diagnostics_);
    else
      refuse_in_section("a component");
  }
  if (tokens_.at_word("end")) take_end(tokens_);
}

// The states in `states:` are items, just as bare states are.
void FileParser::states() {
  states_ = tokens_.open(NodeKind::kStates);
  take_label(tokens_);
}

void FileParser::item_of_states() {
  if (tokens_.at_label("state") && tokens_.at_bare_label()) {
    parse_state(tokens_, diagnostics_);
  } else if (tokens_.at_label("state") || !section_is_over()) {
    refuse_in_section("'state:'");
  } else {
    if (tokens_.at_word("end")) take_end(tokens_);
    tokens_.close(*states_);
    states_.reset();
  }
}

void FileParser::define() {
  const NodeScope section(tokens_, NodeKind::kDefine);
  take_label(tokens_);
  while (!section_is_over()) parse_attribute(tokens_, diagnostics_);
  if (tokens_.at_word("end")) take_end(tokens_);
}

void FileParser::include() {
  line(NodeKind::kInclude, "the path of a file in quotes");
}

void FileParser::start_state() {
  line(NodeKind::kStartState, "the name of a state in quotes");
}

void FileParser::line(NodeKind kind, const std::string& expected) {
  const NodeScope line(tokens_, kind);
  take_label(tokens_);
  if (!take_text(expected)) skip_to_section();
}

void FileParser::on_swap() {
  const NodeScope section(tokens_, NodeKind::kOnSwap);
  take_label(tokens_);
  while (tokens_.at(TokenKind::kText)) {
    if (!swap()) return skip_to_section();
    if (tokens_.at(TokenKind::kComma)) tokens_.take();
  }
  if (tokens_.at_word("end")) return take_end(tokens_);
  if (!section_is_over()) refuse_in_section("a line such as \"old state\": \"new state\"");
}

bool FileParser::swap() {
  const NodeScope line(tokens_, NodeKind::kSwap);
  tokens_.take();
  if (!tokens_.at(TokenKind::kColon)) {
    refuse("':' and the new state's name");
    return false;
  }
  tokens_.take();
  return take_text("the new state's name in quotes");
}

bool FileParser::section_is_over() const {
  return tokens_.at_end_of_file() || tokens_.at_word("end") || next_section_begins();
}

bool FileParser::next_section_begins() const {
  return at_section(tokens_) ||
         (tokens_.at_label_before_label() && !meant_section(tokens_).empty());
}

void FileParser::refuse(const std::string& expected) {
  diagnostics_.error(tokens_.position(), "syntax/unexpected-token",
                     expected + " is expected, found " + describe(tokens_.peek()));
}

// Skips every `end` on the way, because the depth of the lost text is unknown.
void FileParser::refuse_in_section(const std::string& expected) {
  refuse(expected);
  const NodeScope lost(tokens_, NodeKind::kError);
  do tokens_.take();
  while (!tokens_.at_end_of_file() && !next_section_begins() && !tokens_.at_bare_label());
}

void FileParser::refuse_outside() {
  if (tokens_.at_word("end")) {
    diagnostics_.error(tokens_.position(), "syntax/unexpected-end", "this 'end' closes nothing");
    const NodeScope lost(tokens_, NodeKind::kError);
    return take_end(tokens_);
  }
  if (const auto word = meant_section(tokens_); !word.empty()) {
    diagnostics_.error(tokens_.position(), "syntax/unknown-word",
                       in_quotes(tokens_.peek().text) + " is no section", did_you_mean(word));
    return section(word);
  }
  diagnostics_.error(tokens_.position(), "syntax/unexpected-token",
                     describe(tokens_.peek()) + " stands outside every section",
                     "open one with 'variables:', 'motor_schemas:', 'states:' …, or take away "
                     "an 'end' before");
  skip_to_section_behind();
}

void FileParser::skip_to_section() {
  if (tokens_.at_end_of_file() || next_section_begins()) return;
  skip_to_section_behind();
}

/// Skips the token at hand and goes on to where the next section begins.
void FileParser::skip_to_section_behind() {
  const NodeScope lost(tokens_, NodeKind::kError);
  tokens_.take();
  while (!tokens_.at_end_of_file() && !next_section_begins()) tokens_.take();
}

bool FileParser::take_text(const std::string& expected) {
  const bool is_text = tokens_.at(TokenKind::kText);
  if (is_text)
    tokens_.take();
  else
    refuse(expected);
  return is_text;
}

}  // namespace galilean::bhdl
