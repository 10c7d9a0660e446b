#include "bhdl/syntax/parser.h"

#include "bhdl/source/names.h"
#include "bhdl/source/text.h"
#include "bhdl/syntax/component_parser.h"
#include "bhdl/syntax/expectation_parser.h"
#include "bhdl/syntax/keywords.h"
#include "bhdl/syntax/state_parser.h"
#include "bhdl/syntax/token_stream.h"

namespace galilean::bhdl {
namespace {

class FileParser {
 public:
  FileParser(std::string_view file, std::string_view text, Diagnostics& diagnostics)
      : tokens_(file, text, diagnostics), diagnostics_(diagnostics) {}

  SyntaxTree parse() {
    while (!tokens_.at_end_of_file()) {
      if (at_section_word(tokens_))
        section(tokens_.peek().text);
      else
        refuse_outside();
    }
    return std::move(tree_);
  }

 private:
  void section(std::string_view word) {
    if (const auto kind = section_kind(word)) return components(*kind);
    if (word == "states") return states();
    if (word == "state") return state();
    if (word == "define") return define();
    if (word == "expect") return expectation();
    if (word == "include") return include();
    if (word == "start_state") return start_state();
    on_swap();
  }

  void components(ComponentKind kind) {
    SectionNode section{take_label(tokens_), kind, {}};
    const auto block = kind == ComponentKind::kVariable ? Block::kVariable : Block::kComponent;
    while (!section_is_over()) {
      if (tokens_.at_bare_label() || tokens_.at_unlabelled_block())
        section.components.push_back(parse_component(tokens_, block, diagnostics_));
      else
        refuse_in_section("a component");
    }
    if (tokens_.at_word("end")) take_end(tokens_);
    tree_.emplace_back(std::move(section));
  }

  // Bare states and those in a section are the same to everybody else.
  void states() {
    take_label(tokens_);
    while (tokens_.at_label("state") || !section_is_over()) {
      if (tokens_.at_label("state") && tokens_.at_bare_label())
        state();
      else
        refuse_in_section("'state:'");
    }
    if (tokens_.at_word("end")) take_end(tokens_);
  }

  void state() { tree_.emplace_back(parse_state(tokens_, diagnostics_)); }

  void expectation() { tree_.emplace_back(parse_expectation(tokens_, diagnostics_)); }

  void define() {
    take_label(tokens_);
    DefineNode node;
    while (!section_is_over()) parse_attribute(tokens_, node.constants, diagnostics_);
    if (tokens_.at_word("end")) take_end(tokens_);
    tree_.emplace_back(std::move(node));
  }

  void include() {
    take_label(tokens_);
    if (const auto path = expect_text("the path of a file in quotes"))
      tree_.emplace_back(IncludeNode{*path});
    else
      skip_to_section();
  }

  void start_state() {
    take_label(tokens_);
    if (const auto name = expect_text("the name of a state in quotes"))
      tree_.emplace_back(StartStateNode{*name});
    else
      skip_to_section();
  }

  void on_swap() {
    take_label(tokens_);
    while (tokens_.at(TokenKind::kText)) {
      if (!swap()) return skip_to_section();
      if (tokens_.at(TokenKind::kComma)) tokens_.take();
    }
    if (tokens_.at_word("end")) return take_end(tokens_);
    if (!section_is_over()) refuse_in_section("a line such as \"old state\": \"new state\"");
  }

  bool swap() {
    const Token old_state = tokens_.take();
    if (!tokens_.at(TokenKind::kColon)) {
      refuse("':' and the new state's name");
      return false;
    }
    tokens_.take();
    const auto new_state = expect_text("the new state's name in quotes");
    if (new_state) tree_.emplace_back(SwapNode{{old_state.text, old_state.at}, *new_state});
    return new_state.has_value();
  }

  [[nodiscard]] bool section_is_over() const {
    return tokens_.at_end_of_file() || tokens_.at_word("end") || next_section_begins();
  }
  [[nodiscard]] bool next_section_begins() const {
    return at_section(tokens_) ||
           (tokens_.at_label_before_label() && !meant_section(tokens_).empty());
  }

  void refuse(const std::string& expected) {
    diagnostics_.error(tokens_.peek().at, "syntax/unexpected-token",
                       expected + " is expected, found " + describe(tokens_.peek()));
  }

  // Takes the ends on its way: how deep the lost text was is not known.
  void refuse_in_section(const std::string& expected) {
    refuse(expected);
    do tokens_.take();
    while (!tokens_.at_end_of_file() && !next_section_begins() && !tokens_.at_bare_label());
  }

  void refuse_outside() {
    if (tokens_.at_word("end")) {
      diagnostics_.error(tokens_.peek().at, "syntax/unexpected-end", "this 'end' closes nothing");
      return take_end(tokens_);
    }
    if (const auto word = meant_section(tokens_); !word.empty()) {
      diagnostics_.error(tokens_.peek().at, "syntax/unknown-word",
                         in_quotes(tokens_.peek().text) + " is no section", did_you_mean(word));
      return section(word);
    }
    diagnostics_.error(tokens_.peek().at, "syntax/unexpected-token",
                       describe(tokens_.peek()) + " stands outside every section",
                       "open one with 'variables:', 'motor_schemas:', 'states:' …, or take away "
                       "an 'end' before");
    tokens_.take();
    skip_to_section();
  }

  void skip_to_section() {
    while (!tokens_.at_end_of_file() && !next_section_begins()) tokens_.take();
  }

  std::optional<Word> expect_text(const std::string& expected) {
    if (tokens_.at(TokenKind::kText)) {
      const Token text = tokens_.take();
      return Word{text.text, text.at};
    }
    refuse(expected);
    return std::nullopt;
  }

  TokenStream tokens_;
  Diagnostics& diagnostics_;
  SyntaxTree tree_;
};

}  // namespace

SyntaxTree parse(std::string_view file, std::string_view text, Diagnostics& diagnostics) {
  return FileParser(file, text, diagnostics).parse();
}

}  // namespace galilean::bhdl
