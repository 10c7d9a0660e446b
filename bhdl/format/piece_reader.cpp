#include "bhdl/format/piece_list.h"
#include "bhdl/syntax/keywords.h"

namespace galilean::bhdl {
namespace {

using Role = Piece::Role;

std::string plain_text(const Token& text) {
  return '"' + std::string(text.text) + '"';
}

// Typesetting made dashes of the listings' hyphens; a number's own digits are plain.
std::string plain_number(const Token& number) {
  const auto digits = number.text.find_first_of("0123456789.");
  return (digits > 0 ? "-" : "") + std::string(number.text.substr(digits));
}

std::string plain(const Token& value) {
  if (value.kind == TokenKind::kText) return plain_text(value);
  return value.kind == TokenKind::kNumber ? plain_number(value) : std::string(value.text);
}

/// Walks a text as the parser does, but for errors: there are none.
class PieceReader {
 public:
  PieceReader(std::string_view file, std::string_view text) : pieces_(file, text) {}

  std::vector<Piece> read() {
    while (!tokens_.at_end_of_file()) section(tokens_.peek().text);
    pieces_.begin(Role::kEndOfFile);
    return std::move(pieces_).take();
  }

 private:
  void section(std::string_view word) {
    if (const auto kind = section_kind(word)) return components(*kind);
    if (word == "states") return states();
    if (word == "state") return state();
    if (word == "define") return define();
    if (word == "expect") return expectation();
    if (word == "include") return line("include ");
    if (word == "start_state") return line("start_state: ");
    on_swap();
  }

  void components(ComponentKind kind) {
    const std::size_t opened = pieces_.open(std::string(section_word(kind)));
    pieces_.at(opened).aligns_labels = true;
    const bool variables = kind == ComponentKind::kVariable;
    bool closed = false;
    while (!section_is_over()) closed = variables ? variable() : component();
    close_section(opened, variables && closed);
  }

  void states() {
    const std::size_t opened = pieces_.open("states");
    while (tokens_.at_label("state")) state();
    close_section(opened, false);
  }

  void define() {
    const std::size_t opened = pieces_.open("define");
    while (!section_is_over()) attribute();
    close_section(opened, false);
  }

  // In `variables:` the last variable took the `end` that a reader sees as the section's.
  void close_section(std::size_t opened, bool has_taken_end) {
    if (tokens_.at_word("end"))
      pieces_.close(opened);
    else if (has_taken_end)
      pieces_.return_end(opened);
    else
      pieces_.add_close(opened, "end");
  }

  /// Whether it had an `end` of its own, which it does not need.
  bool variable() {
    const std::size_t opened = pieces_.open(std::string(tokens_.peek().text));
    while (!tokens_.at_word("end") && !section_is_over() && !tokens_.at_bare_label()) attribute();
    const bool has_end = tokens_.at_word("end");
    if (has_end)
      pieces_.drop_end(opened);
    else
      pieces_.add_close(opened, "");
    return has_end;
  }

  bool component() {
    const std::size_t opened = pieces_.open(std::string(tokens_.peek().text));
    while (!tokens_.at_word("end") && !tokens_.at_end_of_file()) attribute();
    pieces_.close(opened);
    return true;
  }

  void state() {
    const std::size_t opened = pieces_.open("state");
    while (!tokens_.at_word("end") && !tokens_.at_end_of_file()) {
      if (tokens_.at_label("condition"))
        component();
      else if (at_schema_list(tokens_))
        schema_list();
      else
        attribute();
    }
    pieces_.close(opened);
  }

  void expectation() {
    const std::size_t opened = pieces_.open("expect");
    while (!tokens_.at_word("end") && !tokens_.at_end_of_file()) {
      if (tokens_.at_bare_label())
        component();
      else
        attribute();
    }
    pieces_.close(opened);
  }

  void schema_list() {
    const auto kind = section_kind(tokens_.peek().text).value_or(ComponentKind::kMotorSchema);
    const std::size_t opened = pieces_.open(std::string(section_word(kind)));
    values();
    pieces_.close(opened);
  }

  void on_swap() {
    const std::size_t opened = pieces_.open("on_swap");
    while (tokens_.at(TokenKind::kText)) {
      std::string text = plain_text(pieces_.begin(Role::kLine)) + ": ";
      pieces_.more();
      text += plain_text(pieces_.more());
      pieces_.last().text = std::move(text);
      if (tokens_.at(TokenKind::kComma)) pieces_.more();
    }
    close_section(opened, false);
  }

  void line(const std::string& label) {
    pieces_.begin(Role::kLine);
    if (tokens_.at(TokenKind::kColon)) pieces_.more();
    pieces_.last().text = label + plain_text(pieces_.more());
  }

  void attribute() {
    const Token name = pieces_.begin(Role::kAttribute);
    pieces_.last().text = std::string(name.text) + ':';
    pieces_.more();
    values();
  }

  void values() {
    bool word_may_follow = true;
    while (tokens_.value_at(0) && (!tokens_.at(TokenKind::kWord) || word_may_follow)) {
      const bool is_word = tokens_.at(TokenKind::kWord);
      value();
      const bool has_comma = tokens_.at(TokenKind::kComma);
      word_may_follow = is_word || has_comma;
      if (!has_comma) continue;
      pieces_.more();
      // Without it a word here would be a number's unit, or an attribute whose colon is missing.
      if (!is_word && tokens_.at(TokenKind::kWord)) pieces_.last().text += ',';
    }
  }

  void value() {
    const Token first = pieces_.begin(Role::kValue);
    if (first.kind != TokenKind::kLess && first.kind != TokenKind::kLeftParen) {
      pieces_.last().text = quantity(first);
      return;
    }
    std::string text = std::string(first.text) + quantity(pieces_.more()) + ", ";
    if (tokens_.at(TokenKind::kComma)) pieces_.more();
    text += quantity(pieces_.more());
    pieces_.last().text = text.append(pieces_.more().text);
  }

  /// A value with its unit, if it has one: behind a number a word is nothing else.
  std::string quantity(const Token& value) {
    std::string text = plain(value);
    const bool has_unit =
        value.kind == TokenKind::kNumber && tokens_.at(TokenKind::kWord) && tokens_.value_at(0);
    if (has_unit) text.append(" ").append(pieces_.more().text);
    return text;
  }

  [[nodiscard]] bool section_is_over() const {
    return tokens_.at_end_of_file() || tokens_.at_word("end") || at_section(tokens_);
  }

  PieceList pieces_;
  const TokenStream& tokens_ = pieces_.tokens();
};

}  // namespace

std::vector<Piece> read_pieces(std::string_view file, std::string_view text) {
  return PieceReader(file, text).read();
}

}  // namespace galilean::bhdl
