// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/top/screen/encoder.h"

#include <algorithm>
#include <array>
#include <bit>
#include <utility>

#include "monitor/top/screen/utf8.h"

namespace galilean::monitor::top {
namespace {

constexpr std::array<std::pair<char32_t, char>, 42> kAlike{
    {{U'▶', '>'}, {U'▸', '>'}, {U'▾', 'v'},  {U'→', '>'},  {U'←', '<'}, {U'↑', '^'}, {U'↓', 'v'},
     {U'↗', '/'}, {U'↙', '/'}, {U'↖', '\\'}, {U'↘', '\\'}, {U'·', '.'}, {U'…', '~'}, {U'±', '+'},
     {U'−', '-'}, {U'–', '-'}, {U'µ', 'u'},  {U'°', 'd'},  {U'≠', '#'}, {U'×', 'x'}, {U'✓', 'v'},
     {U'●', '*'}, {U'○', 'o'}, {U'▒', ':'},  {U'░', '.'},  {U'▓', '#'}, {U'█', '#'}, {U'─', '-'},
     {U'│', '|'}, {U'├', '+'}, {U'└', '+'},  {U'┌', '+'},  {U'┐', '+'}, {U'┘', '+'}, {U'┤', '+'},
     {U'┬', '+'}, {U'┴', '+'}, {U'┼', '+'},  {U'■', '#'},  {U'□', 'o'}, {U'►', '>'}, {U'◄', '<'}}};

/// Appends the moves and characters of one screen, in one style after the other.
class Writer {
 public:
  Writer(std::string& to, const Look& look) : to_(to), look_(look) {}

  void put(int row, int column, const Cell& cell) {
    if (row != row_ || column != column_)
      to_ += "\x1b[" + std::to_string(row + 1) + ";" + std::to_string(column + 1) + "H";
    if (!is_styled_ || style_ != cell.style) to_ += escape_sequence(cell.style, look_.colours);
    style_ = cell.style;
    is_styled_ = true;
    if (look_.ascii)
      to_ += ascii_for(cell.glyph);
    else
      append_utf8(to_, cell.glyph);
    row_ = row;
    column_ = column + 1;
  }
  void end() {
    if (is_styled_) to_ += "\x1b[0m";
  }

 private:
  std::string& to_;
  const Look& look_;
  int row_ = -1, column_ = -1;
  Style style_ = Style::kPlain;
  bool is_styled_ = false;
};

}  // namespace

char ascii_for(char32_t glyph) noexcept {
  if (glyph < 0x7f) return static_cast<char>(glyph);
  if (glyph >= 0x2800 && glyph <= 0x28ff) {  // Braille: by its number of dots
    constexpr std::string_view kDots = " ..:::***";
    return kDots[static_cast<std::size_t>(std::popcount(static_cast<unsigned>(glyph) & 0xffU))];
  }
  if (glyph >= 0x2581 && glyph <= 0x2587)  // blocks from below
    return std::string_view("_.-=+*#")[glyph - 0x2581];
  const auto alike = std::ranges::find(kAlike, glyph, &std::pair<char32_t, char>::first);
  return alike == kAlike.end() ? '?' : alike->second;
}

std::string changes(const Canvas* before, const Canvas& now, const Look& look) {
  const bool anew = !before || before->columns() != now.columns() || before->rows() != now.rows();
  std::string bytes = anew ? "\x1b[0m\x1b[2J" : "";
  Writer writer(bytes, look);
  for (int row = 0; row < now.rows(); ++row)
    for (int column = 0; column < now.columns(); ++column) {
      const Cell& cell = now.at(row, column);
      if (cell != (anew ? Cell{} : before->at(row, column))) writer.put(row, column, cell);
    }
  writer.end();
  return bytes;
}

}  // namespace galilean::monitor::top
