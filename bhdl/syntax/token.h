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

/// A line and a column, both from 1. Columns count characters.
struct Place {
  int line = 1;
  int column = 1;
};

struct Token {
  TokenKind kind = TokenKind::kEndOfFile;
  std::uint8_t open_quote = 0;   ///< bytes before `text`
  std::uint8_t close_quote = 0;  ///< bytes behind `text`; 0 also if the end of the line ends the
                                 ///< text
  Place at;
  std::string_view text;  ///< as written; of a text without its quotes
  double number = 0;

  /// Returns the token as written, with its quotes.
  [[nodiscard]] std::string_view whole() const noexcept {
    return {text.data() - open_quote, open_quote + text.size() + close_quote};
  }
};

/// Returns how a message names a token: "'min_sphere'", "the end of the file".
[[nodiscard]] std::string describe(const Token& token);

}  // namespace galilean::bhdl
