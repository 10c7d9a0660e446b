// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>

namespace galilean::monitor::top {

/// Takes one character off the front of UTF-8; '?' for what is none.
[[nodiscard]] char32_t take_character(std::string_view& text);
void append_utf8(std::string& to, char32_t character);
/// One cell wide in every terminal, and unable to move the cursor: Latin, Greek, Cyrillic,
/// punctuation, arrows, boxes and blocks.
[[nodiscard]] bool is_plain(char32_t character) noexcept;
/// Characters, each a cell wide.
[[nodiscard]] int width_of(std::string_view text);

}  // namespace galilean::monitor::top
