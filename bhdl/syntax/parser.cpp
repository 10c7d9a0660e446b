#include "bhdl/syntax/parser.h"

#include <algorithm>

#include "bhdl/source/names.h"
#include "bhdl/source/text.h"
#include "bhdl/syntax/component_parser.h"
#include "bhdl/syntax/expectation_parser.h"
#include "bhdl/syntax/keywords.h"
#include "bhdl/syntax/lowering.h"
#include "bhdl/syntax/state_parser.h"
#include "bhdl/syntax/token_stream.h"

namespace galilean::bhdl {
namespace {

/// Of the ends of the file one stays.
void drop_look_ahead(ParseTree& tree) {
  const auto is_end = [](const Token& token) { return token.kind == TokenKind::kEndOfFile; };
  tree.tokens.erase(std::ranges::find_if(tree.tokens, is_end) + 1, tree.tokens.end());
}

class FileParser {
 public:
  FileParser(std::string_view file, ParseTree& tree, Diagnostics& diagnostics)
      : tokens_(file, tree, diagnostics), diagnostics_(diagnostics) {}

  void parse() {
    while (!tokens_.at_end_of_file()) {
      if (at_section_word(tokens_))
        section(tokens_.peek().text);
      else
        refuse_outside();
    }
  }

 private:
  void section(std::string_view word) {
    if (const auto kind = section_kind(word)) return components(*kind);
    if (word == "states") return states();
    if (word == "state") return parse_state(tokens_, diagnostics_);
    if (word == "define") return define();
    if (word == "expect") return parse_expectation(tokens_, diagnostics_);
    if (word == "include") return include();
    if (word == "start_state") return start_state();
    on_swap();
  }

  void components(ComponentKind kind) {
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

  void states() {
    const NodeScope section(tokens_, NodeKind::kStates);
    take_label(tokens_);
    while (tokens_.at_label("state") || !section_is_over()) {
      if (tokens_.at_label("state") && tokens_.at_bare_label())
        parse_state(tokens_, diagnostics_);
      else
        refuse_in_section("'state:'");
    }
    if (tokens_.at_word("end")) take_end(tokens_);
  }

  void define() {
    const NodeScope section(tokens_, NodeKind::kDefine);
    take_label(tokens_);
    while (!section_is_over()) parse_attribute(tokens_, diagnostics_);
    if (tokens_.at_word("end")) take_end(tokens_);
  }

  void include() { line(NodeKind::kInclude, "the path of a file in quotes"); }
  void start_state() { line(NodeKind::kStartState, "the name of a state in quotes"); }

  void line(NodeKind kind, const std::string& expected) {
    const NodeScope line(tokens_, kind);
    take_label(tokens_);
    if (!take_text(expected)) skip_to_section();
  }

  void on_swap() {
    const NodeScope section(tokens_, NodeKind::kOnSwap);
    take_label(tokens_);
    while (tokens_.at(TokenKind::kText)) {
      if (!swap()) return skip_to_section();
      if (tokens_.at(TokenKind::kComma)) tokens_.take();
    }
    if (tokens_.at_word("end")) return take_end(tokens_);
    if (!section_is_over()) refuse_in_section("a line such as \"old state\": \"new state\"");
  }

  bool swap() {
    const NodeScope line(tokens_, NodeKind::kSwap);
    tokens_.take();
    if (!tokens_.at(TokenKind::kColon)) {
      refuse("':' and the new state's name");
      return false;
    }
    tokens_.take();
    return take_text("the new state's name in quotes");
  }

  [[nodiscard]] bool section_is_over() const {
    return tokens_.at_end_of_file() || tokens_.at_word("end") || next_section_begins();
  }
  [[nodiscard]] bool next_section_begins() const {
    return at_section(tokens_) ||
           (tokens_.at_label_before_label() && !meant_section(tokens_).empty());
  }

  void refuse(const std::string& expected) {
    diagnostics_.error(tokens_.position(), "syntax/unexpected-token",
                       expected + " is expected, found " + describe(tokens_.peek()));
  }

  // Takes the ends on its way: how deep the lost text was is not known.
  void refuse_in_section(const std::string& expected) {
    refuse(expected);
    const NodeScope lost(tokens_, NodeKind::kError);
    do tokens_.take();
    while (!tokens_.at_end_of_file() && !next_section_begins() && !tokens_.at_bare_label());
  }

  void refuse_outside() {
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

  void skip_to_section() {
    if (tokens_.at_end_of_file() || next_section_begins()) return;
    skip_to_section_behind();
  }

  /// Where the next section begins behind the token at hand.
  void skip_to_section_behind() {
    const NodeScope lost(tokens_, NodeKind::kError);
    tokens_.take();
    while (!tokens_.at_end_of_file() && !next_section_begins()) tokens_.take();
  }

  bool take_text(const std::string& expected) {
    const bool is_text = tokens_.at(TokenKind::kText);
    if (is_text)
      tokens_.take();
    else
      refuse(expected);
    return is_text;
  }

  TokenStream tokens_;
  Diagnostics& diagnostics_;
};

}  // namespace

ParseTree parse_tree(std::string_view file, std::string_view text, Diagnostics& diagnostics) {
  ParseTree tree{text, {}, {}};
  FileParser(file, tree, diagnostics).parse();
  drop_look_ahead(tree);
  return tree;
}

SyntaxTree parse(std::string_view file, std::string_view text, Diagnostics& diagnostics) {
  return lowered(parse_tree(file, text, diagnostics), file);
}

}  // namespace galilean::bhdl
