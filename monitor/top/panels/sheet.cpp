// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/top/panels/sheet.h"

#include <algorithm>

#include "monitor/top/panels/panels.h"

namespace galilean::monitor::top {
namespace {

constexpr int kMark = 2;  ///< cells before a list's lines

int scroll_of(const Sheet& sheet, int count, int room) {
  if (!sheet.chosen) return clamped_scroll(sheet.scroll, count, room);
  const int chosen = static_cast<int>(*sheet.chosen);
  return clamped_scroll(std::clamp(sheet.scroll, chosen - room + 1, chosen), count, room);
}

void draw_line(const Sheet& sheet, std::size_t number, int row, Canvas& canvas) {
  const auto& line = sheet.lines[number];
  const bool chosen = sheet.chosen == number;
  const int begin = sheet.chosen ? 1 + kMark : 1;
  if (chosen) canvas.put(row, 1, "▶", Style::kBold);
  canvas.put(row, begin, line.text,
             chosen && line.style == Style::kPlain ? Style::kBold : line.style,
             canvas.columns() - begin);
}

}  // namespace

void lay_over(Sheet& sheet, Canvas& canvas) {
  const int columns = canvas.columns(), below = sheet.notice.empty() ? 1 : 2;
  const int most = canvas.rows() - 5 - below;
  const int count = static_cast<int>(sheet.lines.size());
  const int room = std::clamp(count, 1, std::max(1, most));
  const int row = canvas.rows() - below - room - 1;
  sheet.scroll = scroll_of(sheet, count, room);
  canvas.fill({row, 0, canvas.rows() - row, columns}, Style::kPlain);
  for (int column = 0; column < columns; ++column) canvas.set(row, column, U'─', Style::kDim);
  canvas.put(row, 2, " " + sheet.title + " ", Style::kBold, columns - 2);
  for (int i = 0; i < std::min(room, count); ++i)
    draw_line(sheet, static_cast<std::size_t>(sheet.scroll + i), row + 1 + i, canvas);
  if (!sheet.notice.empty())
    canvas.put(canvas.rows() - 2, 1, sheet.notice, Style::kWarning, columns - 1);
  std::string keys = sheet.keys;
  if (count > room && !sheet.chosen) keys += "  ↑↓ scroll";
  canvas.put(canvas.rows() - 1, 0, keys, Style::kBold);
}

}  // namespace galilean::monitor::top
