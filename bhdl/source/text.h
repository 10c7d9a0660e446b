// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace galilean::bhdl {

/// Why a text cannot be BHDL at all, and where. `line` and `column` count from 1, columns in
/// characters.
struct BadText {
  enum class Kind { kBinary, kNotUtf8 };
  Kind kind = Kind::kBinary;
  int line = 1;
  int column = 1;
  unsigned byte = 0;
};
/// Returns the first byte that no BHDL text may hold: a control character other than tab and line
/// ends, or a byte that breaks UTF-8. Returns nothing if there is none.
[[nodiscard]] std::optional<BadText> find_bad_text(std::string_view text) noexcept;

/// Returns how many bytes the UTF-8 character at the start of `text` takes, or 0 if there is none.
[[nodiscard]] std::size_t character_size(std::string_view text) noexcept;

/// Returns how many characters a UTF-8 text has.
[[nodiscard]] std::size_t character_count(std::string_view text) noexcept;

/// Returns `'text'`, in which invisible characters are shown as their codes, such as U+200B. A long
/// text is cut, so that the message stays readable.
[[nodiscard]] std::string in_quotes(std::string_view text);
/// Returns the shortest decimal text that reads back as `number`.
[[nodiscard]] std::string number_text(double number);
[[nodiscard]] std::string lower_case(std::string_view text);

}  // namespace galilean::bhdl
