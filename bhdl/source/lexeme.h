// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <string_view>

namespace galilean::bhdl {

// Each returns how many bytes of that kind a text begins with; 0 if it begins with none.

[[nodiscard]] std::size_t blank_size(std::string_view text) noexcept;  ///< line ends are no blanks
[[nodiscard]] std::size_t quote_size(std::string_view text) noexcept;
[[nodiscard]] std::size_t minus_size(std::string_view text) noexcept;
/// Line ends are \n, \r\n and \r. Otherwise a file from an old Mac would be one long comment.
[[nodiscard]] std::size_t line_end_size(std::string_view text) noexcept;

[[nodiscard]] std::size_t word_size(std::string_view text) noexcept;
/// Measures `word [^ digit] [/ word [^ digit]]`.
[[nodiscard]] std::size_t unit_size(std::string_view text) noexcept;
/// Measures `digits [. digits] [e [sign] digits]`, without a sign before it.
[[nodiscard]] std::size_t number_size(std::string_view text) noexcept;
/// Measures the content of a text, up to its closing quote or the end of the line. It may be 0.
[[nodiscard]] std::size_t quoted_size(std::string_view text) noexcept;
/// Measures a comment up to the end of its line.
[[nodiscard]] std::size_t comment_size(std::string_view text) noexcept;

namespace character {

enum Class : unsigned char {
  kLetter = 1,  ///< begins a word
  kDigit = 2,
  kEndsQuoted = 4  ///< or may end it: the first byte of all quotes in UTF-8
};

[[nodiscard]] constexpr std::array<unsigned char, 256> make_classes() noexcept {
  std::array<unsigned char, 256> classes{};
  for (int c = 'a'; c <= 'z'; ++c) classes[static_cast<unsigned char>(c)] = kLetter;
  for (int c = 'A'; c <= 'Z'; ++c) classes[static_cast<unsigned char>(c)] = kLetter;
  for (int c = '0'; c <= '9'; ++c) classes[static_cast<unsigned char>(c)] = kDigit;
  classes['_'] = kLetter;
  for (const char c : {'"', '\n', '\r', '\xE2'})
    classes[static_cast<unsigned char>(c)] = kEndsQuoted;
  return classes;
}
inline constexpr auto kClasses = make_classes();

[[nodiscard]] constexpr bool is(char c, int classes) noexcept {
  return (kClasses[static_cast<unsigned char>(c)] & classes) != 0;
}

}  // namespace character

}  // namespace galilean::bhdl
