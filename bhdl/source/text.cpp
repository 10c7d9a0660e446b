// SPDX-License-Identifier: BSD-3-Clause
#include "bhdl/source/text.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdint>
#include <cstring>

#include "core/cut_text.h"
#include "core/visible_text.h"

namespace galilean::bhdl {
namespace {

constexpr std::size_t kLongestQuoted = 60;

bool continues(unsigned char byte) noexcept {
  return (byte & 0xC0) == 0x80;
}

// The second byte alone decides whether a character is overlong, a surrogate or too large.
bool second_byte_fits(unsigned char first, unsigned char second) noexcept {
  switch (first) {
    case 0xE0:
      return second >= 0xA0;
    case 0xED:
      return second < 0xA0;
    case 0xF0:
      return second >= 0x90;
    case 0xF4:
      return second < 0x90;
    default:
      return true;
  }
}

std::size_t expected_size(unsigned char first) noexcept {
  if (first < 0x80) return 1;
  if (first >= 0xC2 && first <= 0xDF) return 2;
  if (first >= 0xE0 && first <= 0xEF) return 3;
  if (first >= 0xF0 && first <= 0xF4) return 4;
  return 0;
}

bool is_control(unsigned char byte) noexcept {
  return (byte < 0x20 && byte != '\t' && byte != '\n' && byte != '\r' && byte != '\f') ||
         byte == 0x7F;
}

bool is_plain(unsigned char byte) noexcept {
  return byte >= 0x20 && byte < 0x7F;
}

/// Returns whether the next eight bytes are all plain. The tests of eight bytes are done in one
/// word.
bool eight_are_plain(const char* bytes) noexcept {
  constexpr std::uint64_t kEach = 0x0101010101010101;
  std::uint64_t word = 0;
  std::memcpy(&word, bytes, sizeof word);
  const std::uint64_t below_blank = (word - kEach * 0x20) & ~word;
  const std::uint64_t beyond_tilde = word | (word + kEach);
  return ((below_blank | beyond_tilde) & (kEach * 0x80)) == 0;
}

BadText bad_text(std::string_view text, std::size_t at, BadText::Kind kind) noexcept {
  BadText bad{.kind = kind, .byte = static_cast<unsigned char>(text[at])};
  std::size_t line = 0;
  for (std::size_t i = 0; i < at; ++i) {
    if (text[i] != '\n' && (text[i] != '\r' || text[i + 1] == '\n')) continue;
    ++bad.line;
    line = i + 1;
  }
  bad.column += static_cast<int>(character_count(text.substr(line, at - line)));
  return bad;
}

}  // namespace

std::size_t character_size(std::string_view text) noexcept {
  if (text.empty()) return 0;
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const std::size_t size = expected_size(byte(0));
  if (size == 0 || size > text.size()) return 0;
  for (std::size_t i = 1; i < size; ++i)
    if (!continues(byte(i))) return 0;
  return size < 2 || second_byte_fits(byte(0), byte(1)) ? size : 0;
}

std::optional<BadText> find_bad_text(std::string_view text) noexcept {
  std::size_t at = 0;
  while (at < text.size()) {
    while (at + 8 <= text.size() && eight_are_plain(text.data() + at)) at += 8;
    if (at == text.size()) break;
    const auto byte = static_cast<unsigned char>(text[at]);
    const std::size_t size = is_plain(byte) ? 1 : character_size(text.substr(at));
    if (size == 0) return bad_text(text, at, BadText::Kind::kNotUtf8);
    if (is_control(byte)) return bad_text(text, at, BadText::Kind::kBinary);
    at += size;
  }
  return std::nullopt;
}

std::size_t character_count(std::string_view text) noexcept {
  return static_cast<std::size_t>(std::ranges::count_if(
      text, [](char c) { return !continues(static_cast<unsigned char>(c)); }));
}

std::string in_quotes(std::string_view text) {
  if (text.size() <= kLongestQuoted) return "'" + visible(text) + "'";
  return "'" + visible(cut_text(text, kLongestQuoted)) + "…'";
}

std::string number_text(double number) {
  std::array<char, 32> digits{};
  const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), number).ptr;
  return {digits.data(), end};
}

std::string lower_case(std::string_view text) {
  std::string lower(text);
  std::ranges::transform(lower, lower.begin(), [](char c) {
    return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  });
  return lower;
}

}  // namespace galilean::bhdl
