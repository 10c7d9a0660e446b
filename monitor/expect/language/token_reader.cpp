// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/expect/language/token_reader.h"

#include <algorithm>

#include "bhdl/source/names.h"
#include "core/cut_text.h"

namespace galilean::expect {
namespace {

constexpr std::size_t kLongestText = 300;

}  // namespace

const Token& TokenReader::peek(std::size_t ahead) const noexcept {
  return tokens_[std::min(at_ + ahead, tokens_.size() - 1)];
}

bool TokenReader::at_word(std::string_view word, std::size_t ahead) const noexcept {
  return peek(ahead).kind == TokenKind::kWord && peek(ahead).text == word;
}

const Token& TokenReader::next() noexcept {
  const Token& token = peek();
  if (at_ + 1 < tokens_.size()) ++at_;
  return token;
}

bool TokenReader::take(TokenKind kind) noexcept {
  return at(kind) && (next(), true);
}

bool TokenReader::take_word(std::string_view word) noexcept {
  return at_word(word) && (next(), true);
}

bool TokenReader::expect(TokenKind kind, std::string_view name) {
  return take(kind) || expected(name);
}

bool TokenReader::expect_word(std::string_view word) {
  return take_word(word) || expected("'" + std::string(word) + "'", {word});
}

bool TokenReader::expected(std::string_view what, std::initializer_list<std::string_view> words) {
  const Token& token = peek();
  bhdl::Hint hint;
  if (token.kind == TokenKind::kWord)
    hint = bhdl::did_you_mean(meant_name(token.text, std::vector(words)));
  return error(token, "syntax/unexpected-token",
               "expected " + std::string(what) + ", not " + describe(token), std::move(hint));
}

bool TokenReader::error(const Token& token, std::string_view code, const std::string& message,
                        bhdl::Hint hint) {
  if (!failed_) diagnostics_.error(location(token), code, message, std::move(hint));
  failed_ = true;
  return false;
}

void TokenReader::recover(std::span<const std::string_view> words) {
  failed_ = false;
  while (!at(TokenKind::kEnd)) {
    const bool comma = next().kind == TokenKind::kComma;
    if (comma && at(TokenKind::kWord) && std::ranges::find(words, peek().text) != words.end())
      return;
  }
}

std::string TokenReader::text_since(std::size_t position) const {
  std::string text;
  for (std::size_t i = position; i < at_ && text.size() < kLongestText; ++i) {
    const Token& token = tokens_[i];
    const bool apart = i > position && tokens_[i - 1].end != token.begin;
    if (apart) text += ' ';
    text.append(token.begin, token.end);
  }
  if (text.size() < kLongestText) return text;
  return std::string(cut_text(text, kLongestText - 1)) + "…";
}

}  // namespace galilean::expect
