// SPDX-License-Identifier: BSD-3-Clause
#include "bhdl/syntax/lexer.h"

#include <charconv>
#include <cmath>
#include <utility>

#include "bhdl/source/lexeme.h"
#include "bhdl/source/text.h"

namespace galilean::bhdl {
namespace {

using character::is;
using character::kDigit;
using character::kLetter;

constexpr std::string_view kByteOrderMark = "\uFEFF";

/// Returns the kind of a punctuation mark, or kEndOfFile if the character is none.
TokenKind punctuation_kind(char c) noexcept {
  switch (c) {
    case ':':
      return TokenKind::kColon;
    case ',':
      return TokenKind::kComma;
    case '<':
      return TokenKind::kLess;
    case '>':
      return TokenKind::kGreater;
    case '(':
      return TokenKind::kLeftParen;
    case ')':
      return TokenKind::kRightParen;
    default:
      return TokenKind::kEndOfFile;
  }
}

}  // namespace

std::string describe(const Token& token) {
  if (token.kind == TokenKind::kEndOfFile) return "the end of the file";
  if (token.kind == TokenKind::kText) return "the text " + in_quotes(token.text);
  return in_quotes(token.text);
}

Lexer::Lexer(std::string_view file, std::string_view text, Diagnostics& diagnostics)
    : file_(file), rest_(text), diagnostics_(diagnostics) {
  if (rest_.starts_with(kByteOrderMark)) step(kByteOrderMark.size());
  counted_ = rest_.data();
}

Lexer::Lexer(std::string_view file, std::string_view text, const Token& first, bool after_number,
             Diagnostics& diagnostics)
    : file_(file),
      rest_(text.substr(static_cast<std::size_t>(first.whole().data() - text.data()))),
      at_(first.at),
      counted_(rest_.data()),
      after_number_(after_number),
      diagnostics_(diagnostics) {}

Token Lexer::next() {
  const bool after_number = std::exchange(after_number_, false);
  for (;;) {
    skip_blanks();
    if (done()) return token(TokenKind::kEndOfFile, 0);
    const char c = rest_.front();
    if (is(c, kLetter))
      return token(TokenKind::kWord, after_number ? unit_size(rest_) : word_size(rest_));
    if (quote_size(rest_) > 0) return text();
    if (const auto kind = punctuation_kind(c); kind != TokenKind::kEndOfFile) return token(kind, 1);
    if (starts_number()) return number();
    refuse_characters();
  }
}

void Lexer::skip_blanks() noexcept {
  while (!done()) {
    if (const auto blank = blank_size(rest_))
      step(blank);
    else if (const auto line_end = line_end_size(rest_))
      end_line(line_end);
    else if (rest_.front() == ';')
      step(comment_size(rest_));
    else
      return;
  }
}

void Lexer::end_line(std::size_t bytes) noexcept {
  step(bytes);
  ++at_.line;
  at_.column = 1;
  counted_ = rest_.data();
}

// Characters are counted only from the place counted last, so that each is counted at most once.
Place Lexer::place() noexcept {
  const auto bytes = static_cast<std::size_t>(rest_.data() - counted_);
  at_.column += static_cast<int>(character_count({counted_, bytes}));
  counted_ = rest_.data();
  return at_;
}

bool Lexer::starts_number() const noexcept {
  const auto digits = rest_.substr(minus_size(rest_));
  if (digits.empty()) return false;
  return is(digits[0], kDigit) || (digits[0] == '.' && digits.size() > 1 && is(digits[1], kDigit));
}

Token Lexer::token(TokenKind kind, std::size_t bytes) {
  Token token;
  token.kind = kind;
  token.at = place();
  token.text = rest_.substr(0, bytes);
  step(bytes);
  return token;
}

Token Lexer::text() {
  Token token;
  token.kind = TokenKind::kText;
  token.at = place();
  token.open_quote = static_cast<std::uint8_t>(quote_size(rest_));
  step(token.open_quote);
  token.text = rest_.substr(0, quoted_size(rest_));
  step(token.text.size());
  token.close_quote = static_cast<std::uint8_t>(quote_size(rest_));
  step(token.close_quote);
  if (token.close_quote == 0)
    diagnostics_.error(position(token.at), "syntax/unclosed-text",
                       "this text has no closing quote on its line", "end it with \"");
  return token;
}

Token Lexer::number() {
  const Place at = place();
  const std::string_view whole = rest_;
  const auto minus = minus_size(rest_);
  step(minus);
  const auto digits = rest_.substr(0, number_size(rest_));
  double value = 0;
  const auto parsed = std::from_chars(digits.data(), digits.data() + digits.size(), value);
  step(digits.size());
  if (parsed.ec == std::errc::result_out_of_range || !std::isfinite(value)) {
    diagnostics_.error(position(at), "syntax/number",
                       "the number " + in_quotes(digits) + " cannot be held");
    value = 0;
  }
  refuse_second_point(digits, at);
  after_number_ = true;
  Token token;
  token.kind = TokenKind::kNumber;
  token.at = at;
  token.text = whole.substr(0, whole.size() - rest_.size());
  token.number = minus > 0 ? -value : value;
  return token;
}

void Lexer::refuse_second_point(std::string_view digits, const Place& at) {
  if (!rest_.starts_with('.')) return;
  std::size_t size = 0;
  while (size < rest_.size() && (rest_[size] == '.' || is(rest_[size], kLetter | kDigit))) ++size;
  diagnostics_.error(
      position(at), "syntax/number",
      in_quotes(std::string(digits) + std::string(rest_.substr(0, size))) + " is not a number",
      "a number has one decimal point");
  step(size);
}

bool Lexer::starts_token() const noexcept {
  const char c = rest_.front();
  return blank_size(rest_) > 0 || line_end_size(rest_) > 0 || c == ';' || is(c, kLetter) ||
         quote_size(rest_) > 0 || punctuation_kind(c) != TokenKind::kEndOfFile || starts_number();
}

void Lexer::refuse_characters() {
  const Place at = place();
  const auto first = rest_.substr(0, character_size(rest_));
  do step(1);
  while (!done() && !starts_token());
  diagnostics_.error(position(at), "syntax/unexpected-character",
                     "the character " + in_quotes(first) + " has no meaning here",
                     "a comment begins with ; and a name stands in quotes");
}

}  // namespace galilean::bhdl
