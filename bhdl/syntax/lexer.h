// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string_view>

#include "bhdl/source/diagnostic.h"
#include "bhdl/syntax/token.h"

namespace galilean::bhdl {

/// Cuts a text into tokens, one at a time. Bytes that are no token are reported and skipped. Every
/// text can be cut. Requires: the text is UTF-8 if its diagnostics are shown, because messages
/// quote it.
class Lexer {
 public:
  Lexer(std::string_view file, std::string_view text, Diagnostics& diagnostics);
  /// Begins with `first`, a token of the text. `after_number` says that the token before it is a
  /// number.
  Lexer(std::string_view file, std::string_view text, const Token& first, bool after_number,
        Diagnostics& diagnostics);

  /// Returns the next token. After the last one it always returns kEndOfFile.
  [[nodiscard]] Token next();

 private:
  [[nodiscard]] bool done() const noexcept { return rest_.empty(); }
  void step(std::size_t bytes) noexcept { rest_.remove_prefix(bytes); }
  void skip_blanks() noexcept;
  void end_line(std::size_t bytes) noexcept;
  [[nodiscard]] Place place() noexcept;
  [[nodiscard]] Position position(const Place& at) const noexcept {
    return {file_, at.line, at.column};
  }
  [[nodiscard]] bool starts_number() const noexcept;
  [[nodiscard]] bool starts_token() const noexcept;
  Token token(TokenKind kind, std::size_t bytes);
  Token text();
  Token number();
  void refuse_second_point(std::string_view digits, const Place& at);
  void refuse_characters();

  std::string_view file_;
  std::string_view rest_;
  Place at_;                   ///< the place of `counted_`
  const char* counted_;        ///< the line's characters up to here are counted
  bool after_number_ = false;  ///< so that m/s and px^2 are words only there
  Diagnostics& diagnostics_;
};

}  // namespace galilean::bhdl
