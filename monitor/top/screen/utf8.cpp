// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/top/screen/utf8.h"

namespace galilean::monitor::top {
namespace {

bool continues(std::string_view text, std::size_t index) {
  return index < text.size() && (static_cast<unsigned char>(text[index]) & 0xc0) == 0x80;
}

/// Returns the number of bytes of the character that begins with `lead`, or 0 if none does.
std::size_t length_by(unsigned char lead) {
  if (lead < 0x80) return 1;
  if ((lead & 0xe0) == 0xc0) return 2;
  if ((lead & 0xf0) == 0xe0) return 3;
  if ((lead & 0xf8) == 0xf0) return 4;
  return 0;
}

}  // namespace

char32_t take_character(std::string_view& text) {
  const auto lead = static_cast<unsigned char>(text[0]);
  const std::size_t length = length_by(lead);
  char32_t character = length > 1 ? lead & (0x7f >> length) : lead;
  bool whole = length > 0;
  for (std::size_t i = 1; whole && i < length; ++i) {
    whole = continues(text, i);
    if (whole) character = (character << 6) | (static_cast<unsigned char>(text[i]) & 0x3f);
  }
  text.remove_prefix(whole ? length : 1);
  return whole ? character : U'?';
}

void append_utf8(std::string& to, char32_t character) {
  const auto put = [&](char32_t byte) { to += static_cast<char>(byte); };
  if (character < 0x80) {
    put(character);
  } else if (character < 0x800) {
    put(0xc0 | character >> 6);
    put(0x80 | (character & 0x3f));
  } else if (character < 0x10000) {
    put(0xe0 | character >> 12);
    put(0x80 | (character >> 6 & 0x3f));
    put(0x80 | (character & 0x3f));
  } else {
    put(0xf0 | character >> 18);
    put(0x80 | (character >> 12 & 0x3f));
    put(0x80 | (character >> 6 & 0x3f));
    put(0x80 | (character & 0x3f));
  }
}

bool is_plain(char32_t character) noexcept {
  const auto within = [&](char32_t first, char32_t last) {
    return character >= first && character <= last;
  };
  return within(0x20, 0x7e) || within(0xa0, 0xac) || within(0xae, 0x2ff) || within(0x370, 0x482) ||
         within(0x48a, 0x52f) || within(0x2010, 0x2027) || within(0x2190, 0x21ff) ||
         within(0x2500, 0x25ff) || within(0x2800, 0x28ff) || character == U'−' ||
         character == U'≠' || character == U'✓';
}

int width_of(std::string_view text) {
  int width = 0;
  for (; !text.empty(); ++width) (void)take_character(text);
  return width;
}

std::string in_column(std::string_view text, int width) {
  std::string cells;
  int used = 0;
  for (; !text.empty() && used < width - 1; ++used) append_utf8(cells, take_character(text));
  return cells + std::string(static_cast<std::size_t>(width - used), ' ');
}

}  // namespace galilean::monitor::top
