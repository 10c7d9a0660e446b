// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>

namespace galilean::monitor::top {

/// Removes the first character of UTF-8 text and returns it, or '?' for a byte that begins none.
/// Requires: `text` is not empty.
[[nodiscard]] char32_t take_character(std::string_view& text);
void append_utf8(std::string& to, char32_t character);
/// Returns whether a character is one cell wide in every terminal and does not move the cursor.
/// Such are Latin, Greek, Cyrillic, punctuation, arrows, boxes, blocks and Braille.
[[nodiscard]] bool is_plain(char32_t character) noexcept;
/// Returns the number of cells that the text takes, one for each character.
[[nodiscard]] int width_of(std::string_view text);
/// Returns the text, or its beginning, with blanks behind it up to this width, of which the last
/// cell is a blank.
[[nodiscard]] std::string in_column(std::string_view text, int width);

}  // namespace galilean::monitor::top
