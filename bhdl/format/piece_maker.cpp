// SPDX-License-Identifier: BSD-3-Clause
#include "bhdl/format/piece_list.h"
#include "bhdl/syntax/keywords.h"

namespace galilean::bhdl {
namespace {

using Role = Piece::Role;

std::string plain_text(const Token& text) {
  return '"' + std::string(text.text) + '"';
}

// Typesetting turned the listings' hyphens into dashes. Here a minus becomes a hyphen again.
std::string plain_number(const Token& number) {
  const auto digits = number.text.find_first_of("0123456789.");
  return (digits > 0 ? "-" : "") + std::string(number.text.substr(digits));
}

std::string plain(const Token& value) {
  if (value.kind == TokenKind::kText) return plain_text(value);
  return value.kind == TokenKind::kNumber ? plain_number(value) : std::string(value.text);
}

class PieceMaker {
 public:
  explicit PieceMaker(const ParseTree& tree) : tree_(tree), pieces_(tree) {}

  std::vector<Piece> run() {
    for (const auto node : tree_.roots()) part(node);
    pieces_.begin(Role::kEndOfFile);
    return std::move(pieces_).take();
  }

 private:
  // The recursion is only as deep as the grammar: sections, states, conditions.
  void part(std::uint32_t i) {
    const Node& node = tree_.nodes[i];
    switch (node.kind) {
      case NodeKind::kSection:
        return components(i, static_cast<ComponentKind>(node.sense));
      case NodeKind::kStates:
      case NodeKind::kDefine:
        return section(i);
      case NodeKind::kOnSwap:
        return on_swap(i);
      case NodeKind::kSwap:
        return swap();
      case NodeKind::kInclude:
        return line("include ");
      case NodeKind::kStartState:
        return line("start_state: ");
      case NodeKind::kSchemaList:
        return schema_list(i, static_cast<ComponentKind>(node.sense));
      case NodeKind::kAttribute:
        return attribute(i);
      default:
        return block(i);
    }
  }

  void parts(std::uint32_t block) {
    for (const auto node : tree_.children(block)) part(node);
  }

  void components(std::uint32_t i, ComponentKind kind) {
    const std::size_t opened = pieces_.open(std::string(section_word(kind)));
    pieces_.at(opened).aligns_labels = true;
    bool closed = false;
    if (kind == ComponentKind::kVariable)
      for (const auto node : tree_.children(i)) closed = variable(node);
    else
      parts(i);
    close_section(i, opened, closed);
  }

  void section(std::uint32_t i) {
    const std::size_t opened = open(i);
    parts(i);
    close_section(i, opened, false);
  }

  // In `variables:` the parser gave the section's `end` to the last variable. It is given back
  // here.
  void close_section(std::uint32_t i, std::size_t opened, bool has_taken_end) {
    if (has_more(i))
      pieces_.close(opened);
    else if (has_taken_end)
      pieces_.return_end(opened);
    else
      pieces_.add_close(opened, "end");
  }

  /// Lays out a variable. Returns whether it had an `end`, which it does not need.
  bool variable(std::uint32_t i) {
    const std::size_t opened = open(i);
    parts(i);
    const bool has_end = has_more(i);
    if (has_end)
      pieces_.drop_end(opened);
    else
      pieces_.add_close(opened, "");
    return has_end;
  }

  void block(std::uint32_t i) {
    const std::size_t opened = open(i);
    parts(i);
    pieces_.close(opened);
  }

  void schema_list(std::uint32_t i, ComponentKind kind) {
    const std::size_t opened = pieces_.open(std::string(section_word(kind)));
    values(i);
    pieces_.close(opened);
  }

  void on_swap(std::uint32_t i) {
    const std::size_t opened = open(i);
    for (const auto node : tree_.children(i)) {
      part(node);
      if (pieces_.at(TokenKind::kComma)) pieces_.more();
    }
    close_section(i, opened, false);
  }

  void swap() {
    std::string text = plain_text(pieces_.begin(Role::kLine)) + ": ";
    pieces_.more();
    text += plain_text(pieces_.more());
    pieces_.last().text = std::move(text);
  }

  void line(const std::string& label) {
    pieces_.begin(Role::kLine);
    if (pieces_.at(TokenKind::kColon)) pieces_.more();
    pieces_.last().text = label + plain_text(pieces_.more());
  }

  void attribute(std::uint32_t i) {
    const Token& name = pieces_.begin(Role::kAttribute);
    pieces_.last().text = std::string(name.text) + ':';
    pieces_.more();
    values(i);
  }

  void values(std::uint32_t i) {
    for (const auto node : tree_.children(i)) {
      const bool is_word = pieces_.at(TokenKind::kWord);
      value(tree_.nodes[node]);
      if (!pieces_.at(TokenKind::kComma)) continue;
      pieces_.more();
      // Without the comma, a word would be read as a number's unit, or as an attribute without its
      // colon.
      if (!is_word && pieces_.at(TokenKind::kWord)) pieces_.last().text += ',';
    }
  }

  void value(const Node& node) {
    const Token& first = pieces_.begin(Role::kValue);
    if (ValueSense{node.sense} != ValueSense::kPair) {
      pieces_.last().text = quantity(first, node);
      return;
    }
    std::string text = std::string(first.text) + quantity(pieces_.more(), node) + ", ";
    if (pieces_.at(TokenKind::kComma)) pieces_.more();
    text += quantity(pieces_.more(), node);
    pieces_.last().text = text.append(pieces_.more().text);
  }

  /// Returns a value with its unit, if it has one. A word behind a number in a value is always its
  /// unit.
  std::string quantity(const Token& value, const Node& node) {
    std::string text = plain(value);
    const bool has_unit = value.kind == TokenKind::kNumber && pieces_.next() < node.end_token &&
                          pieces_.at(TokenKind::kWord);
    if (has_unit) text.append(" ").append(pieces_.more().text);
    return text;
  }

  std::size_t open(std::uint32_t i) {
    return pieces_.open(std::string(tree_.first_token(tree_.nodes[i]).text));
  }
  /// Returns whether the block's `end` is still to be taken. Requires: all its parts were read.
  [[nodiscard]] bool has_more(std::uint32_t i) const {
    return pieces_.next() < tree_.nodes[i].end_token;
  }

  const ParseTree& tree_;
  PieceList pieces_;
};

}  // namespace

std::vector<Piece> pieces_of(const ParseTree& tree) {
  return PieceMaker(tree).run();
}

}  // namespace galilean::bhdl
