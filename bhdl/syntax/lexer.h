#pragma once

#include <string>
#include <string_view>

#include "bhdl/source/diagnostic.h"
#include "bhdl/syntax/syntax.h"

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
  void step(std::size_t bytes) noexcept { rest_.remove_prefix(bytes); }
  void skip_blanks() noexcept;
  void end_line(std::size_t bytes) noexcept;
  [[nodiscard]] Position position() noexcept;
  [[nodiscard]] bool starts_number() const noexcept;
  [[nodiscard]] bool starts_token() const noexcept;
  Token token(TokenKind kind, std::size_t bytes);
  Token text();
  Token number();
  void refuse_second_point(std::string_view digits, const Position& at);
  void refuse_characters();

  std::string_view rest_;
  Position at_;                ///< of `counted_`
  const char* counted_;        ///< up to here the line's characters are counted
  bool after_number_ = false;  ///< so that m/s and px^2 are words there and nowhere else
  Diagnostics& diagnostics_;
};

}  // namespace galilean::bhdl
