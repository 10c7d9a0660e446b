// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "bhdl/source/diagnostic.h"

namespace galilean::expect {

enum class TokenKind {
  kWord,    ///< also a unit such as m/s behind a number, and %
  kText,    ///< "grab_trash"
  kNumber,  ///< 3.25
  kTopic,   ///< /io/state, ~/state or /io/odom.twist.twist.linear.x
  kOperator,
  kColon,
  kComma,
  kLeftParen,
  kRightParen,
  kEnd  ///< the end of the expectation
};

struct Token {
  TokenKind kind = TokenKind::kEnd;
  std::string_view text;  ///< as written; of a text without its quotes
  double number = 0;
  int line = 1, column = 1;     ///< from 1; columns count characters
  const char* begin = nullptr;  ///< in the file, with a text's quote
  const char* end = nullptr;
};

/// Returns how a message names a token: "'within'", "the end of the expectation".
[[nodiscard]] std::string describe(const Token& token);

/// The tokens of each expectation of a file. Every list ends with kEnd.
using TokenLists = std::vector<std::vector<Token>>;

/// Cuts a text into expectations. Each begins at the start of a line; lines that begin with a blank
/// continue it. What is no token is reported and skipped. The tokens point into `text`.
[[nodiscard]] TokenLists cut(const std::string& file, std::string_view text,
                             bhdl::Diagnostics& diagnostics);

}  // namespace galilean::expect
