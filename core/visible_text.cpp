// SPDX-License-Identifier: BSD-3-Clause
#include "core/visible_text.h"

#include <algorithm>
#include <array>
#include <cstdio>

namespace galilean {
namespace {

struct CodeRange {
  char32_t first, last;
};

/// The blank U+0020 is not among them.
constexpr std::array kInvisible{
    CodeRange{0x00, 0x1F},        // C0 controls
    CodeRange{0x7F, 0xA0},        // delete, C1 controls, no-break space
    CodeRange{0xAD, 0xAD},        // soft hyphen
    CodeRange{0x34F, 0x34F},      // combining grapheme joiner
    CodeRange{0x61C, 0x61C},      // Arabic letter mark
    CodeRange{0x115F, 0x1160},    // Hangul fillers
    CodeRange{0x1680, 0x1680},    // Ogham space mark
    CodeRange{0x17B4, 0x17B5},    // Khmer inherent vowels
    CodeRange{0x180B, 0x180F},    // Mongolian separators
    CodeRange{0x2000, 0x200F},    // blanks of other widths, zero width, marks of direction
    CodeRange{0x2028, 0x202F},    // separators, embeddings, narrow no-break space
    CodeRange{0x205F, 0x206F},    // blank, word joiner, isolates
    CodeRange{0x2800, 0x2800},    // Braille blank
    CodeRange{0x3000, 0x3000},    // ideographic space
    CodeRange{0x3164, 0x3164},    // Hangul filler
    CodeRange{0xFE00, 0xFE0F},    // variation selectors
    CodeRange{0xFEFF, 0xFEFF},    // byte order mark
    CodeRange{0xFFA0, 0xFFA0},    // half-width Hangul filler
    CodeRange{0xFFF0, 0xFFFB},    // not assigned, annotations
    CodeRange{0xFFFE, 0xFFFF},    // no characters
    CodeRange{0x1BCA0, 0x1BCA3},  // shorthand controls
    CodeRange{0x1D173, 0x1D17A},  // musical controls
    CodeRange{0xE0000, 0xE0FFF},  // tags, variation selectors
};

bool is_invisible(char32_t code) {
  return std::ranges::any_of(kInvisible, [code](const CodeRange& range) {
    return code >= range.first && code <= range.last;
  });
}

struct Character {
  char32_t code = 0;
  std::size_t size = 0;  ///< 0: the text begins with no character of UTF-8
};

/// Requires: `text` is not empty.
Character first_character(std::string_view text) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  if (byte(0) < 0x80) return {byte(0), 1};
  const std::size_t size = byte(0) >= 0xF0 ? 4 : byte(0) >= 0xE0 ? 3 : 2;
  if (byte(0) < 0xC2 || byte(0) > 0xF4 || text.size() < size) return {};
  char32_t code = byte(0) & (0x7FU >> size);
  for (std::size_t i = 1; i < size; ++i) {
    if ((byte(i) & 0xC0U) != 0x80U) return {};
    code = code << 6 | (byte(i) & 0x3FU);
  }
  constexpr std::array<char32_t, 5> kLeast{0, 0, 0x80, 0x800, 0x10000};
  const bool is_surrogate = code >= 0xD800 && code <= 0xDFFF;
  return code < kLeast.at(size) || code > 0x10FFFF || is_surrogate ? Character{}
                                                                   : Character{code, size};
}

std::string code_text(const char* format, unsigned number) {
  std::array<char, 16> text{};
  std::snprintf(text.data(), text.size(), format, number);
  return text.data();
}

}  // namespace

std::string visible(std::string_view text) {
  std::string shown;
  while (!text.empty()) {
    const Character character = first_character(text);
    const std::size_t size = std::max<std::size_t>(character.size, 1);
    if (character.size == 0)
      shown += code_text("0x%02X", static_cast<unsigned char>(text[0]));
    else if (is_invisible(character.code))
      shown += code_text("U+%04X", static_cast<unsigned>(character.code));
    else
      shown += text.substr(0, size);
    text.remove_prefix(size);
  }
  return shown;
}

}  // namespace galilean
