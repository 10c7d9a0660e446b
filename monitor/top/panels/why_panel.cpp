// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>

#include "core/plural.h"
#include "monitor/top/panels/panels.h"
#include "monitor/top/screen/utf8.h"

namespace galilean::monitor::top {
namespace {

struct WhyLine {
  std::string when;  ///< empty below a change
  std::string text;
  Style style = Style::kPlain;
};

std::string joined(const std::vector<std::string>& names) {
  std::string text;
  for (const auto& name : names) text += (text.empty() ? "" : ", ") + name;
  return text;
}

std::vector<WhyLine> why_lines(const std::vector<ShownChange>& changes) {
  std::vector<WhyLine> lines;
  for (const auto& change : changes) {
    lines.push_back(
        {lasting(change.ago_s), change.from_state + " → " + change.to_state, Style::kBold});
    lines.push_back(
        {"", change.cause + (change.place.empty() ? "" : "  " + change.place), Style::kPlain});
    if (!change.held_too.empty())
      lines.push_back({"", "also held: " + joined(change.held_too), Style::kWarning});
    if (change.filled) lines.push_back({"", "filled after a gap", Style::kDim});
    if (change.missed > 0)
      lines.push_back(
          {"", plural(change.missed, "change") + " before this not heard", Style::kWarning});
  }
  return lines;
}

}  // namespace

void draw_why(const View& view, const Area& area, int& scroll, Canvas& canvas) {
  constexpr int kWhen = 8;
  if (area.rows < 2) return;
  const auto lines = why_lines(view.changes);
  const int count = static_cast<int>(lines.size()), room = area.rows - 1;
  scroll = clamped_scroll(scroll, count, room);
  const std::string below = count - scroll > room ? "and more" : "";
  draw_panel_heading("WHY", below, area, canvas);
  if (lines.empty())
    canvas.put(area.row + 1, area.column, "No change of state has been heard yet.", Style::kDim,
               area.columns);
  for (int i = 0; i < std::min(room, count - scroll); ++i) {
    const WhyLine& line = lines[static_cast<std::size_t>(scroll + i)];
    const int row = area.row + 1 + i;
    canvas.put(row, area.column + kWhen - 1 - width_of(line.when), line.when, Style::kDim);
    canvas.put(row, area.column + kWhen, line.text, line.style, area.columns - kWhen);
  }
}

}  // namespace galilean::monitor::top
