#pragma once

#include <string>
#include <string_view>

#include "bhdl/diagnostic.h"
#include "bhdl/syntax.h"

namespace galilean::bhdl {

enum class TokenKind {
  kWord,    ///< bits_variable; behind a number also m/s and px^2
  kText,    ///< "wander" or “wander”
  kNumber,  ///< 3.25, -200 or –200
  kColon,
  kComma,
  kLess,
  kGreater,
  kLeftParen,
  kRightParen,
  kEndOfFile
};

struct Token {
  TokenKind kind = TokenKind::kEndOfFile;
  std::string_view text;  ///< as written; a text's without its quotes
  double number = 0;
  Position at;
};

/// How a message names a token: "'min_sphere'", "the end of the file".
[[nodiscard]] std::string describe(const Token& token);

/// Cuts a text into tokens, one at a time, so that memory does not grow with the file. What is no
/// token is reported and stepped over. The text must have passed find_bad_text.
class Lexer {
 public:
  Lexer(std::string_view file, std::string_view text, Diagnostics& diagnostics);

  /// The next token; kEndOfFile for ever after the last one.
  [[nodiscard]] Token next();

 private:
  [[nodiscard]] bool done() const noexcept { return rest_.empty(); }
  [[nodiscard]] bool sees(std::string_view expected) const noexcept {
    return rest_.starts_with(expected);
  }
  void step() noexcept;
  void step_over(std::size_t bytes) noexcept;
  void skip_blanks();
  [[nodiscard]] std::size_t blank_size() const noexcept;
  [[nodiscard]] std::size_t quote_size() const noexcept;
  [[nodiscard]] std::size_t minus_size() const noexcept;
  [[nodiscard]] bool starts_number() const noexcept;
  Token punctuation(TokenKind kind);
  Token word(std::size_t size);
  Token text();
  Token number();
  void refuse_second_point(std::string_view digits, const Position& at);
  void refuse_characters();

  std::string_view rest_;
  Position at_;
  bool after_number_ = false;  ///< so that m/s and px^2 are words there and nowhere else
  Diagnostics& diagnostics_;
};

}  // namespace galilean::bhdl
