// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "bhdl/syntax/syntax.h"

namespace galilean::bhdl {

enum class TokenKind : std::uint8_t {
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

/// Line and column from 1; columns count characters.
struct Place {
  int line = 1;
  int column = 1;
};

struct Token {
  TokenKind kind = TokenKind::kEndOfFile;
  std::uint8_t open_quote = 0;   ///< bytes before `text`
  std::uint8_t close_quote = 0;  ///< bytes behind it; 0 also of a text that its line ends
  Place at;
  std::string_view text;  ///< as written; a text's without its quotes
  double number = 0;

  /// As written, with its quotes.
  [[nodiscard]] std::string_view whole() const noexcept {
    return {text.data() - open_quote, open_quote + text.size() + close_quote};
  }
};

/// How a message names a token: "'min_sphere'", "the end of the file".
[[nodiscard]] std::string describe(const Token& token);

}  // namespace galilean::bhdl
