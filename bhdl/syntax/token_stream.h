// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string_view>

#include "bhdl/syntax/label_resolver.h"
#include "bhdl/syntax/lexer.h"
#include "bhdl/syntax/parse_tree.h"

namespace galilean::bhdl {

/// Fills a tree with the lexer's tokens and the parser's nodes. It looks ahead as far as the
/// grammar needs: `word : word :` shows that a component begins, and no attribute without a value.
class TokenStream {
 public:
  TokenStream(std::string_view file, ParseTree& tree, Diagnostics& diagnostics)
      : file_(file), tree_(tree), lexer_(file, tree.text, diagnostics) {
    look_ahead();
  }
  /// Goes on behind the tree's tokens, at `first`, which is a token of the tree's text.
  TokenStream(std::string_view file, ParseTree& tree, const Token& first, bool after_number,
              Diagnostics& diagnostics, const LabelResolver* resolver = nullptr)
      : file_(file),
        tree_(tree),
        lexer_(file, tree.text, first, after_number, diagnostics),
        next_(tree.tokens.size()),
        resolver_(resolver) {
    look_ahead();
  }

  [[nodiscard]] const Token& peek(std::size_t ahead = 0) const noexcept {
    return tree_.tokens[next_ + ahead];
  }
  /// Returns the last token that the lexer has read.
  [[nodiscard]] const Token& farthest() const noexcept { return tree_.tokens.back(); }
  /// Returns the number of the token at hand.
  [[nodiscard]] std::uint32_t next() const noexcept { return static_cast<std::uint32_t>(next_); }
  [[nodiscard]] Position position(const Token& token) const noexcept {
    return {file_, token.at.line, token.at.column};
  }
  [[nodiscard]] Position position() const noexcept { return position(peek()); }

  /// Takes the token at hand. The end of the file is never passed.
  Token take() {
    const Token token = peek();
    if (token.kind == TokenKind::kEndOfFile) return token;
    tree_.tokens.push_back(lexer_.next());
    ++next_;
    return token;
  }

  /// Removes the tokens ahead from the tree. The end of the file stays if it is at hand.
  void drop_look_ahead() { tree_.tokens.resize(next_ + (at_end_of_file() ? 1 : 0)); }

  /// Removes the nodes and the tokens that were taken from the tree.
  void forget() {
    const auto taken = static_cast<std::ptrdiff_t>(next_);
    tree_.tokens.erase(tree_.tokens.begin(), tree_.tokens.begin() + taken);
    tree_.nodes.clear();
    next_ = 0;
  }

  std::uint32_t open(NodeKind kind, std::uint8_t sense = 0) {
    tree_.nodes.push_back({kind, sense, next(), 0, 0});
    return static_cast<std::uint32_t>(tree_.nodes.size() - 1);
  }
  void close(std::uint32_t node) noexcept {
    tree_.nodes[node].end_token = next();
    tree_.nodes[node].end_node = static_cast<std::uint32_t>(tree_.nodes.size());
  }
  void set_sense(std::uint32_t node, std::uint8_t sense) noexcept {
    tree_.nodes[node].sense = sense;
  }

  [[nodiscard]] bool at(TokenKind kind) const noexcept { return peek().kind == kind; }
  [[nodiscard]] bool at_word(std::string_view word) const noexcept {
    return at(TokenKind::kWord) && peek().text == word;
  }
  /// Returns whether `word :` stands here.
  [[nodiscard]] bool at_label() const noexcept { return label_at(0); }
  [[nodiscard]] bool at_label(std::string_view word) const noexcept {
    return at_label() && peek().text == word;
  }
  [[nodiscard]] bool at_end_of_file() const noexcept { return at(TokenKind::kEndOfFile); }
  /// Returns whether `word :` stands here with nothing behind it that could be its value.
  [[nodiscard]] bool at_bare_label() const noexcept { return at_label() && !value_at(2); }
  /// Returns whether `word : word :` stands here, so that the first word is a block's.
  [[nodiscard]] bool at_label_before_label() const noexcept { return at_label() && label_at(2); }

  /// Returns whether a bare label stands here that the block at hand is known to have as an
  /// attribute.
  [[nodiscard]] bool at_known_attribute(NodeKind block, std::string_view type) const {
    return resolver_ != nullptr && at_bare_label() &&
           resolver_->is_attribute(block, type, peek().text);
  }
  [[nodiscard]] bool at_known_component() const {
    return resolver_ != nullptr && at_bare_label() && resolver_->is_component(peek().text);
  }
  /// Returns whether the text ends behind the label at hand.
  [[nodiscard]] bool text_ends_at_label() const noexcept {
    return peek(2).kind == TokenKind::kEndOfFile;
  }

  /// Returns whether `word name` stands here: a block whose colon was forgotten, because a block
  /// begins with its name.
  [[nodiscard]] bool at_unlabelled_block() const noexcept {
    return at(TokenKind::kWord) && peek(1).kind == TokenKind::kWord && peek(1).text == "name" &&
           peek().text != "end";
  }

  [[nodiscard]] bool value_at(std::size_t ahead) const noexcept {
    const Token& token = peek(ahead);
    switch (token.kind) {
      case TokenKind::kNumber:
      case TokenKind::kText:
      case TokenKind::kLess:
      case TokenKind::kLeftParen:
        return true;
      case TokenKind::kWord:
        return token.text != "end" && token.text != "name" &&
               peek(ahead + 1).kind != TokenKind::kColon;
      default:
        return false;
    }
  }

 private:
  static constexpr std::size_t kAhead = 4;

  void look_ahead() {
    for (std::size_t i = 0; i < kAhead; ++i) tree_.tokens.push_back(lexer_.next());
  }
  [[nodiscard]] bool label_at(std::size_t ahead) const noexcept {
    return peek(ahead).kind == TokenKind::kWord && peek(ahead).text != "end" &&
           peek(ahead + 1).kind == TokenKind::kColon;
  }

  std::string_view file_;
  ParseTree& tree_;
  Lexer lexer_;
  std::size_t next_ = 0;
  const LabelResolver* resolver_ = nullptr;
};

/// A node of the tree that ends where this object's scope does.
class NodeScope {
 public:
  NodeScope(TokenStream& tokens, NodeKind kind, std::uint8_t sense = 0)
      : tokens_(tokens), node_(tokens.open(kind, sense)) {}
  NodeScope(const NodeScope&) = delete;
  NodeScope& operator=(const NodeScope&) = delete;
  ~NodeScope() { tokens_.close(node_); }

  void set_sense(std::uint8_t sense) noexcept { tokens_.set_sense(node_, sense); }

 private:
  TokenStream& tokens_;
  std::uint32_t node_;
};

}  // namespace galilean::bhdl
