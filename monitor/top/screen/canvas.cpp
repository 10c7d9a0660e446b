// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/top/screen/canvas.h"

#include <algorithm>

#include "monitor/top/screen/utf8.h"

namespace galilean::monitor::top {

Style robot_style(std::size_t number) noexcept {
  return static_cast<Style>(static_cast<std::size_t>(Style::kRobot) + number % kRobotStyles);
}

Canvas::Canvas(int columns, int rows)
    : columns_(std::max(columns, 1)),
      rows_(std::max(rows, 1)),
      cells_(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_)) {}

void Canvas::set(int row, int column, char32_t glyph, Style style) {
  if (row < 0 || row >= rows_ || column < 0 || column >= columns_) return;
  cells_[index(row, column)] = {is_plain(glyph) ? glyph : U'?', style};
}

void Canvas::fill(const Area& area, Style style) {
  for (int row = area.row; row < area.row + area.rows; ++row)
    for (int column = area.column; column < area.column + area.columns; ++column)
      set(row, column, U' ', style);
}

int Canvas::put(int row, int column, std::string_view text, Style style, int width) {
  for (; !text.empty() && width > 0; --width) set(row, column++, take_character(text), style);
  return column;
}

void Canvas::put_right(int row, int column, std::string_view text, Style style) {
  put(row, column - width_of(text), text, style);
}

std::string Canvas::line(int row) const {
  std::string result;
  std::size_t end = 0;
  for (int column = 0; column < columns_; ++column) {
    append_utf8(result, at(row, column).glyph);
    if (at(row, column).glyph != U' ') end = result.size();
  }
  result.resize(end);
  return result;
}

std::string Canvas::text() const {
  std::string result;
  std::size_t end = 0;
  for (int row = 0; row < rows_; ++row) {
    const std::string next = line(row);
    result += next + "\n";
    if (!next.empty()) end = result.size();
  }
  result.resize(end);
  return result;
}

}  // namespace galilean::monitor::top
