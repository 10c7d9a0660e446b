// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string_view>

namespace galilean::bhdl {

/// A piece of text between two tokens that means nothing to the grammar.
struct Trivia {
  enum class Kind {
    kBlank,    ///< blanks of every kind; a byte order mark is one
    kLineEnd,  ///< one
    kComment,  ///< from its semicolon to the end of its line
    kSkipped   ///< bytes that are no token, which the lexer reported
  };
  Kind kind = Kind::kBlank;
  std::string_view text;
};

/// Returns the first piece of the gap before a token. Requires: the gap is not empty.
[[nodiscard]] Trivia first_trivia(std::string_view gap) noexcept;

}  // namespace galilean::bhdl
