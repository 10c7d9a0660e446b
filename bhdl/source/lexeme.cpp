// SPDX-License-Identifier: BSD-3-Clause
#include "bhdl/source/lexeme.h"

#include <array>

namespace galilean::bhdl {
namespace {

using character::is;
using character::kDigit;
using character::kEndsQuoted;
using character::kLetter;

constexpr std::array<std::string_view, 4> kWideQuotes{"“", "”", "„", "‟"};
// These are en dash, em dash and minus sign: typesetting turned the listings' hyphens into dashes.
constexpr std::array<std::string_view, 3> kWideMinuses{"–", "—", "−"};
// These are the no-break space and the byte order mark.
constexpr std::array<std::string_view, 2> kWideBlanks{"\u00A0", "\uFEFF"};

bool is_ascii(char c) noexcept {
  return static_cast<unsigned char>(c) < 0x80;
}

// Nearly every character is ASCII, so that this test comes before the spellings beyond it.
template <std::size_t N>
std::size_t wide_size(std::string_view text, const std::array<std::string_view, N>& spellings) {
  if (text.empty() || is_ascii(text.front())) return 0;
  for (const auto spelling : spellings)
    if (text.starts_with(spelling)) return spelling.size();
  return 0;
}

std::size_t end_of(std::string_view text, std::size_t from, int classes) noexcept {
  while (from < text.size() && is(text[from], classes)) ++from;
  return from;
}

// Reads `word [^ digit]`.
std::size_t unit_factor_end(std::string_view text, std::size_t from) noexcept {
  const std::size_t end = end_of(text, from, kLetter | kDigit);
  const bool raised = end + 1 < text.size() && text[end] == '^' && is(text[end + 1], kDigit);
  return raised ? end + 2 : end;
}

}  // namespace

std::size_t blank_size(std::string_view text) noexcept {
  if (text.empty()) return 0;
  const char c = text.front();
  return c == ' ' || c == '\t' || c == '\f' ? 1 : wide_size(text, kWideBlanks);
}

std::size_t quote_size(std::string_view text) noexcept {
  return text.starts_with('"') ? 1 : wide_size(text, kWideQuotes);
}

std::size_t minus_size(std::string_view text) noexcept {
  return text.starts_with('-') ? 1 : wide_size(text, kWideMinuses);
}

std::size_t line_end_size(std::string_view text) noexcept {
  if (text.starts_with('\n')) return 1;
  if (!text.starts_with('\r')) return 0;
  return text.size() > 1 && text[1] == '\n' ? 2 : 1;
}

std::size_t word_size(std::string_view text) noexcept {
  return end_of(text, 0, kLetter | kDigit);
}

std::size_t unit_size(std::string_view text) noexcept {
  const std::size_t end = unit_factor_end(text, 0);
  const bool divided = end + 1 < text.size() && text[end] == '/' && is(text[end + 1], kLetter);
  return divided ? unit_factor_end(text, end + 1) : end;
}

std::size_t number_size(std::string_view text) noexcept {
  std::size_t end = end_of(text, 0, kDigit);
  if (end < text.size() && text[end] == '.') end = end_of(text, end + 1, kDigit);
  std::size_t exponent = end;
  if (exponent < text.size() && (text[exponent] == 'e' || text[exponent] == 'E')) {
    ++exponent;
    if (exponent < text.size() && (text[exponent] == '-' || text[exponent] == '+')) ++exponent;
    if (exponent < text.size() && is(text[exponent], kDigit)) end = end_of(text, exponent, kDigit);
  }
  return end;
}

std::size_t quoted_size(std::string_view text) noexcept {
  std::size_t end = 0;
  for (; end < text.size(); ++end) {
    if (!is(text[end], kEndsQuoted)) continue;
    if (is_ascii(text[end]) || quote_size(text.substr(end)) > 0) break;
  }
  return end;
}

std::size_t comment_size(std::string_view text) noexcept {
  std::size_t end = 0;
  while (end < text.size() && text[end] != '\n' && text[end] != '\r') ++end;
  return end;
}

}  // namespace galilean::bhdl
