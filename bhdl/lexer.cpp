#include "bhdl/lexer.h"

#include <array>
#include <charconv>
#include <cmath>
#include <utility>

#include "bhdl/text.h"

namespace galilean::bhdl {
namespace {

constexpr std::string_view kByteOrderMark = "\uFEFF";
constexpr std::array<std::string_view, 5> kQuotes{"\"", "“", "”", "„", "‟"};
// Hyphen, en dash, em dash and the minus sign: typesetting turned the listings' hyphens into
// dashes.
constexpr std::array<std::string_view, 4> kMinuses{"-", "–", "—", "−"};
constexpr std::array<std::string_view, 2> kWideBlanks{"\u00A0", kByteOrderMark};

bool is_digit(char c) noexcept {
  return c >= '0' && c <= '9';
}
bool starts_word(char c) noexcept {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_';
}
bool continues_word(char c) noexcept {
  return starts_word(c) || is_digit(c);
}

template <std::size_t N>
std::size_t match(std::string_view text, const std::array<std::string_view, N>& spellings) {
  for (const auto spelling : spellings)
    if (text.starts_with(spelling)) return spelling.size();
  return 0;
}

template <class Predicate>
std::size_t count_while(std::string_view text, std::size_t from, Predicate holds) {
  while (from < text.size() && holds(text[from])) ++from;
  return from;
}

// digits [. digits] [e [sign] digits]
std::size_t number_size(std::string_view text) {
  std::size_t size = count_while(text, 0, is_digit);
  if (size < text.size() && text[size] == '.') size = count_while(text, size + 1, is_digit);
  std::size_t exponent = size;
  if (exponent < text.size() && (text[exponent] == 'e' || text[exponent] == 'E')) {
    ++exponent;
    if (exponent < text.size() && (text[exponent] == '-' || text[exponent] == '+')) ++exponent;
    if (exponent < text.size() && is_digit(text[exponent]))
      size = count_while(text, exponent, is_digit);
  }
  return size;
}

// word [^ digit]
std::size_t unit_factor_size(std::string_view text, std::size_t from) {
  const std::size_t size = count_while(text, from, continues_word);
  const bool raised = size + 1 < text.size() && text[size] == '^' && is_digit(text[size + 1]);
  return raised ? size + 2 : size;
}

// factor [/ factor]
std::size_t unit_size(std::string_view text) {
  const std::size_t size = unit_factor_size(text, 0);
  const bool divided = size + 1 < text.size() && text[size] == '/' && starts_word(text[size + 1]);
  return divided ? unit_factor_size(text, size + 1) : size;
}

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
    : rest_(text), at_{file, 1, 1}, diagnostics_(diagnostics) {
  if (sees(kByteOrderMark)) rest_.remove_prefix(kByteOrderMark.size());
}

Token Lexer::next() {
  const bool after_number = std::exchange(after_number_, false);
  for (;;) {
    skip_blanks();
    if (done()) return {TokenKind::kEndOfFile, {}, 0, at_};
    const auto kind = punctuation_kind(rest_.front());
    if (kind != TokenKind::kEndOfFile) return punctuation(kind);
    if (starts_word(rest_.front()))
      return word(after_number ? unit_size(rest_) : count_while(rest_, 0, continues_word));
    if (starts_number()) return number();
    if (quote_size() > 0) return text();
    refuse_characters();
  }
}

// Line ends are \n, \r\n and \r: a file from an old Mac must not become one long comment.
void Lexer::step() noexcept {
  const char c = rest_.front();
  const std::size_t size = sees("\r\n") ? 2 : std::max<std::size_t>(1, character_size(rest_));
  rest_.remove_prefix(size);
  const bool line_ends = c == '\n' || c == '\r';
  at_.line += line_ends ? 1 : 0;
  at_.column = line_ends ? 1 : at_.column + 1;
}

void Lexer::step_over(std::size_t bytes) noexcept {
  const std::size_t goal = rest_.size() - bytes;
  while (rest_.size() > goal) step();
}

std::size_t Lexer::blank_size() const noexcept {
  const char c = rest_.front();
  if (c == ' ' || c == '\t' || c == '\n' || c == '\r' || c == '\f') return 1;
  return match(rest_, kWideBlanks);
}

std::size_t Lexer::quote_size() const noexcept {
  return match(rest_, kQuotes);
}

std::size_t Lexer::minus_size() const noexcept {
  return match(rest_, kMinuses);
}

void Lexer::skip_blanks() {
  while (!done()) {
    if (blank_size() > 0)
      step();
    else if (rest_.front() == ';')
      while (!done() && rest_.front() != '\n' && rest_.front() != '\r') step();
    else
      return;
  }
}

bool Lexer::starts_number() const noexcept {
  const auto digits = rest_.substr(minus_size());
  if (digits.empty()) return false;
  return is_digit(digits[0]) || (digits[0] == '.' && digits.size() > 1 && is_digit(digits[1]));
}

Token Lexer::punctuation(TokenKind kind) {
  const Token token{kind, rest_.substr(0, 1), 0, at_};
  step();
  return token;
}

Token Lexer::word(std::size_t size) {
  const Token token{TokenKind::kWord, rest_.substr(0, size), 0, at_};
  step_over(size);
  return token;
}

Token Lexer::text() {
  const Position at = at_;
  step();
  const std::string_view content = rest_;
  while (!done() && quote_size() == 0 && rest_.front() != '\n' && rest_.front() != '\r') step();
  const Token token{TokenKind::kText, content.substr(0, content.size() - rest_.size()), 0, at};
  if (!done() && quote_size() > 0)
    step();
  else
    diagnostics_.error(at, "syntax/unclosed-text", "this text has no closing quote on its line",
                       "end it with \"");
  return token;
}

Token Lexer::number() {
  const Position at = at_;
  const std::string_view whole = rest_;
  const bool negative = minus_size() > 0;
  step_over(minus_size());
  const auto digits = rest_.substr(0, number_size(rest_));
  double value = 0;
  const auto parsed = std::from_chars(digits.data(), digits.data() + digits.size(), value);
  step_over(digits.size());
  if (parsed.ec == std::errc::result_out_of_range || !std::isfinite(value)) {
    diagnostics_.error(at, "syntax/number", "the number " + in_quotes(digits) + " cannot be held");
    value = 0;
  }
  refuse_second_point(digits, at);
  after_number_ = true;
  return {TokenKind::kNumber, whole.substr(0, whole.size() - rest_.size()),
          negative ? -value : value, at};
}

void Lexer::refuse_second_point(std::string_view digits, const Position& at) {
  if (!sees(".")) return;
  const std::size_t size =
      count_while(rest_, 0, [](char c) { return continues_word(c) || c == '.'; });
  diagnostics_.error(
      at, "syntax/number",
      in_quotes(std::string(digits) + std::string(rest_.substr(0, size))) + " is not a number",
      "a number has one decimal point");
  step_over(size);
}

void Lexer::refuse_characters() {
  const Position at = at_;
  const auto first = rest_.substr(0, character_size(rest_));
  do {
    step();
  } while (!done() && blank_size() == 0 && rest_.front() != ';' && quote_size() == 0 &&
           !starts_word(rest_.front()) && !starts_number() &&
           punctuation_kind(rest_.front()) == TokenKind::kEndOfFile);
  diagnostics_.error(at, "syntax/unexpected-character",
                     "the character " + in_quotes(first) + " has no meaning here",
                     "a comment begins with ; and a name stands in quotes");
}

}  // namespace galilean::bhdl
