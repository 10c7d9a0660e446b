// SPDX-License-Identifier: BSD-3-Clause
#include <charconv>
#include <cmath>

#include "bhdl/source/lexeme.h"
#include "bhdl/source/text.h"
#include "monitor/expect/language/token.h"

namespace galilean::expect {
namespace {

using bhdl::character::is;
using bhdl::character::kDigit;
using bhdl::character::kLetter;

bool is_topic_letter(char c) {
  return is(c, kLetter | kDigit) || c == '/' || c == '.' || c == '[' || c == ']';
}

std::size_t topic_size(std::string_view text) {
  const std::size_t root = text.starts_with("~/") ? 2 : text.starts_with('/') ? 1 : 0;
  if (root == 0 || text.size() <= root || !is(text[root], kLetter)) return 0;
  std::size_t end = root;
  while (end < text.size() && is_topic_letter(text[end])) ++end;
  while (text[end - 1] == '.') --end;  // a sentence's full stop is none of it
  return end;
}

std::size_t operator_size(std::string_view text) {
  for (const std::string_view two : {"<=", ">=", "!=", "=="})
    if (text.starts_with(two)) return two.size();
  return text.starts_with('<') || text.starts_with('>') || text.starts_with('=') ? 1 : 0;
}

TokenKind punctuation(char c) {
  switch (c) {
    case ':':
      return TokenKind::kColon;
    case ',':
      return TokenKind::kComma;
    case '(':
      return TokenKind::kLeftParen;
    case ')':
      return TokenKind::kRightParen;
    default:
      return TokenKind::kEnd;
  }
}

class Cutter {
 public:
  Cutter(const std::string& file, std::string_view text, bhdl::Diagnostics& diagnostics)
      : file_(file), rest_(text), counted_(text.data()), diagnostics_(diagnostics) {
    if (rest_.starts_with("\uFEFF")) rest_.remove_prefix(3), counted_ = rest_.data();
  }

  TokenLists cut() {
    while (!rest_.empty()) {
      if (const auto line_end = bhdl::line_end_size(rest_))
        end_line(line_end);
      else if (const auto blank = bhdl::blank_size(rest_))
        rest_.remove_prefix(blank), indented_ = true;
      else if (rest_.front() == ';')
        rest_.remove_prefix(bhdl::comment_size(rest_));
      else
        take_token();
    }
    close();
    return std::move(lists_);
  }

 private:
  void end_line(std::size_t bytes) {
    rest_.remove_prefix(bytes);
    ++line_;
    column_ = 1;
    counted_ = rest_.data();
    indented_ = false;
    fresh_line_ = true;
  }

  /// Returns a token without content at the present place.
  Token place() {
    column_ += static_cast<int>(
        bhdl::character_count({counted_, static_cast<std::size_t>(rest_.data() - counted_)}));
    counted_ = rest_.data();
    Token token;
    token.line = line_;
    token.column = column_;
    token.begin = token.end = rest_.data();
    return token;
  }

  void take_token() {
    if (lists_.empty() || (fresh_line_ && !indented_)) begin_list();
    fresh_line_ = false;
    Token token = place();
    if (const auto quote = bhdl::quote_size(rest_)) return take_text(token, quote);
    std::size_t size = 0;
    const auto take = [&](TokenKind kind, std::size_t bytes) {
      token.kind = kind;
      size = bytes;
      return bytes > 0;
    };
    const bool after_number = after_number_;
    after_number_ = false;
    if (after_number && rest_.starts_with('%'))
      take(TokenKind::kWord, 1);
    else if (after_number && rest_.starts_with("1/s"))
      take(TokenKind::kWord, 3);
    else if (is(rest_.front(), kLetter))
      take(TokenKind::kWord, after_number ? bhdl::unit_size(rest_) : bhdl::word_size(rest_));
    else if (take(TokenKind::kTopic, topic_size(rest_)) ||
             take(TokenKind::kOperator, operator_size(rest_)) ||
             take(punctuation(rest_.front()), punctuation(rest_.front()) != TokenKind::kEnd)) {
    } else if (const auto digits = number_size()) {
      return take_number(token, digits);
    } else {
      return refuse(token);
    }
    push(token, size);
  }

  void push(Token token, std::size_t size) {
    token.text = rest_.substr(0, size);
    token.end = token.begin + size;
    rest_.remove_prefix(size);
    lists_.back().push_back(token);
  }

  void take_text(Token token, std::size_t quote) {
    after_number_ = false;
    token.kind = TokenKind::kText;
    rest_.remove_prefix(quote);
    const auto size = bhdl::quoted_size(rest_);
    token.text = rest_.substr(0, size);
    rest_.remove_prefix(size);
    const auto closing = bhdl::quote_size(rest_);
    if (closing == 0)
      diagnostics_.error(at(token), "syntax/unclosed-text",
                         "the text " + bhdl::in_quotes(token.text) + " has no closing quote",
                         "add a \" before the end of the line");
    rest_.remove_prefix(closing);
    token.end = rest_.data();
    lists_.back().push_back(token);
  }

  [[nodiscard]] std::size_t number_size() const {
    const auto minus = bhdl::minus_size(rest_);
    const auto digits = bhdl::number_size(rest_.substr(minus));
    return digits == 0 ? 0 : minus + digits;
  }

  void take_number(Token token, std::size_t size) {
    token.kind = TokenKind::kNumber;
    const auto minus = bhdl::minus_size(rest_);
    const auto digits = rest_.substr(minus, size - minus);
    const auto read = std::from_chars(digits.data(), digits.data() + digits.size(), token.number);
    if (read.ec != std::errc() || !std::isfinite(token.number)) {
      diagnostics_.error(at(token), "syntax/number",
                         bhdl::in_quotes(rest_.substr(0, size)) + " is too large or too small");
      token.number = 0;
    }
    if (minus > 0) token.number = -token.number;
    push(token, size);
    after_number_ = true;
  }

  /// Reports one message for all characters up to the next that may begin a token.
  void refuse(const Token& token) {
    std::size_t size = std::max<std::size_t>(bhdl::character_size(rest_), 1);
    const bool hash = rest_.front() == '#';
    if (hash) size = bhdl::comment_size(rest_);
    diagnostics_.error(at(token), "syntax/unexpected-character",
                       "unexpected " + bhdl::in_quotes(rest_.substr(0, hash ? 1 : size)),
                       hash ? "a comment begins with ;" : "");
    rest_.remove_prefix(size);
  }

  void begin_list() {
    close();
    lists_.emplace_back();
    after_number_ = false;
  }
  void close() {
    if (lists_.empty()) return;
    Token end = lists_.back().empty() ? place() : lists_.back().back();
    if (!lists_.back().empty()) {
      end.column += static_cast<int>(
          bhdl::character_count({end.begin, static_cast<std::size_t>(end.end - end.begin)}));
      end.begin = end.end;
    }
    end.kind = TokenKind::kEnd;
    end.text = {};
    lists_.back().push_back(end);
  }
  [[nodiscard]] bhdl::Location at(const Token& token) const {
    return {file_, token.line, token.column};
  }

  const std::string& file_;
  std::string_view rest_;
  const char* counted_;  ///< the line's characters up to here are counted
  bhdl::Diagnostics& diagnostics_;
  int line_ = 1, column_ = 1;
  bool fresh_line_ = true, indented_ = false, after_number_ = false;
  TokenLists lists_;
};

}  // namespace

std::string describe(const Token& token) {
  if (token.kind == TokenKind::kEnd) return "the end of the expectation";
  if (token.kind == TokenKind::kText) return "the text " + bhdl::in_quotes(token.text);
  return bhdl::in_quotes(token.text);
}

TokenLists cut(const std::string& file, std::string_view text, bhdl::Diagnostics& diagnostics) {
  return Cutter(file, text, diagnostics).cut();
}

}  // namespace galilean::expect
