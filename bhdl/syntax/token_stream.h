#pragma once

#include <array>
#include <string_view>

#include "bhdl/syntax/lexer.h"

namespace galilean::bhdl {

/// The lexer's tokens with the look-ahead that the grammar needs: `word : word :` tells a component
/// that begins from an attribute without a value.
class TokenStream {
 public:
  TokenStream(std::string_view file, std::string_view text, Diagnostics& diagnostics)
      : lexer_(file, text, diagnostics) {
    for (auto& token : ahead_) token = lexer_.next();
  }

  [[nodiscard]] const Token& peek(std::size_t ahead = 0) const noexcept {
    return ahead_[(first_ + ahead) % kAhead];
  }
  Token take() {
    Token& slot = ahead_[first_];
    const Token token = slot;
    slot = lexer_.next();
    first_ = (first_ + 1) % kAhead;
    return token;
  }

  [[nodiscard]] bool at(TokenKind kind) const noexcept { return peek().kind == kind; }
  [[nodiscard]] bool at_word(std::string_view word) const noexcept {
    return at(TokenKind::kWord) && peek().text == word;
  }
  /// `word :`
  [[nodiscard]] bool at_label() const noexcept { return label_at(0); }
  [[nodiscard]] bool at_label(std::string_view word) const noexcept {
    return at_label() && peek().text == word;
  }
  [[nodiscard]] bool at_end_of_file() const noexcept { return at(TokenKind::kEndOfFile); }
  /// `word :` and nothing that could be its value.
  [[nodiscard]] bool at_bare_label() const noexcept { return at_label() && !value_at(2); }
  /// `word : word :`, so that the first word is a block's.
  [[nodiscard]] bool at_label_before_label() const noexcept { return at_label() && label_at(2); }

  /// `word name`: a block whose colon was forgotten, for a block begins with its name.
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

  [[nodiscard]] bool label_at(std::size_t ahead) const noexcept {
    return peek(ahead).kind == TokenKind::kWord && peek(ahead).text != "end" &&
           peek(ahead + 1).kind == TokenKind::kColon;
  }

  Lexer lexer_;
  std::array<Token, kAhead> ahead_{};
  std::size_t first_ = 0;
};

}  // namespace galilean::bhdl
