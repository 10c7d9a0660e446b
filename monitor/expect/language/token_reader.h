// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <initializer_list>
#include <span>
#include <string>
#include <string_view>

#include "bhdl/source/location.h"
#include "monitor/expect/language/token.h"

namespace galilean::expect {

/// Walks through the tokens of one expectation. What it expects and does not find it reports, once:
/// after the first error it reports nothing until `recover`.
class TokenReader {
 public:
  TokenReader(const std::string& file, const std::vector<Token>& tokens,
              bhdl::Diagnostics& diagnostics)
      : file_(file), tokens_(tokens), diagnostics_(diagnostics) {}

  /// Returns the token that is `ahead` of the next one. Behind the last it is always kEnd.
  [[nodiscard]] const Token& peek(std::size_t ahead = 0) const noexcept;
  [[nodiscard]] bool at(TokenKind kind) const noexcept { return peek().kind == kind; }
  [[nodiscard]] bool at_word(std::string_view word, std::size_t ahead = 0) const noexcept;
  const Token& next() noexcept;
  bool take(TokenKind kind) noexcept;
  bool take_word(std::string_view word) noexcept;

  /// Each takes what it names, or reports that it was expected. `words` are what may be meant.
  bool expect(TokenKind kind, std::string_view name);
  bool expect_word(std::string_view word);
  /// Reports that `what` was expected at the next token. Returns false.
  bool expected(std::string_view what, std::initializer_list<std::string_view> words = {});
  bool error(const Token& token, std::string_view code, const std::string& message,
             bhdl::Hint hint = {});

  [[nodiscard]] bool failed() const noexcept { return failed_; }
  /// Goes to the next comma before one of these words, or to the end, and reports again.
  void recover(std::span<const std::string_view> words);

  [[nodiscard]] bhdl::Location location(const Token& token) const {
    return {file_, token.line, token.column};
  }
  [[nodiscard]] std::size_t position() const noexcept { return at_; }
  /// Returns the text from that token up to the next one, on one line.
  [[nodiscard]] std::string text_since(std::size_t position) const;

 private:
  const std::string& file_;
  const std::vector<Token>& tokens_;
  bhdl::Diagnostics& diagnostics_;
  std::size_t at_ = 0;
  bool failed_ = false;
};

}  // namespace galilean::expect
