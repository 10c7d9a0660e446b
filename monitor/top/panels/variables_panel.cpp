// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>

#include "monitor/top/panels/panels.h"
#include "monitor/top/panels/sparkline.h"
#include "monitor/top/panels/whole_number.h"
#include "monitor/top/screen/utf8.h"

namespace galilean::monitor::top {
namespace {

void draw_bar(int row, int column, int width, double certainty, Style style, Canvas& canvas) {
  const int full = whole_number(certainty * width, 0, width);
  for (int i = 0; i < width; ++i)
    canvas.set(row, column + i, i < full ? U'█' : U'·', i < full ? style : Style::kDim);
}

Style bar_style(double certainty) {
  constexpr double kLow = 0.25, kHalf = 0.5;
  return certainty < kLow ? Style::kAlarm : certainty < kHalf ? Style::kWarning : Style::kGood;
}

void draw_variable(const ShownVariable& variable, int row, const Area& area, Canvas& canvas) {
  constexpr int kBar = 6, kPercent = 5, kName = 15, kValue = 20, kLeastCurve = 8, kMostCurve = 40;
  const int spare = area.columns - (kName + 1 + kBar + kPercent + 1 + kValue + 1);
  const int curve = spare < kLeastCurve ? 0 : std::min(spare, kMostCurve);
  const Style style = variable.certainty > 0 ? Style::kPlain : Style::kDim;
  canvas.put(row, area.column, variable.name, style, kName);
  const int bar = area.column + kName + 1;
  draw_bar(row, bar, kBar, variable.certainty, bar_style(variable.certainty), canvas);
  canvas.put_right(row, bar + kBar + kPercent,
                   std::to_string(whole_number(variable.certainty * 100, 0, 100)) + "%", style);
  canvas.put(row, bar + kBar + kPercent + 1, variable.value, style,
             area.columns - (kName + 1 + kBar + kPercent + 1) - (curve > 0 ? curve + 1 : 0));
  if (curve > 0)
    canvas.put(row, area.column + area.columns - curve, sparkline(variable.recent, curve),
               Style::kDim);
}

/// Returns the variables in the program's order. If there are too many, those whose certainty lies
/// between 0 and 1 come first, then the certain ones, which are often constants and pictures, then
/// the invalid ones.
std::vector<const ShownVariable*> by_informativeness(const std::vector<ShownVariable>& variables,
                                                     bool too_many) {
  std::vector<const ShownVariable*> order;
  for (const auto& variable : variables) order.push_back(&variable);
  if (!too_many) return order;
  const auto rank = [](const ShownVariable* variable) {
    return variable->certainty <= 0 ? 2 : variable->certainty >= 1 ? 1 : 0;
  };
  std::ranges::stable_sort(order, {}, rank);
  return order;
}

}  // namespace

int clamped_scroll(int scroll, int count, int room) noexcept {
  return std::clamp(scroll, 0, std::max(0, count - room));
}

void draw_panel_heading(const std::string& heading, const std::string& remark, const Area& area,
                        Canvas& canvas) {
  const int end = canvas.put(area.row, area.column, heading, Style::kHeading, area.columns);
  if (area.column + area.columns - end > width_of(remark))
    canvas.put_right(area.row, area.column + area.columns, remark, Style::kDim);
}

void draw_variables(const View& view, const Area& area, int& scroll, Canvas& canvas) {
  if (area.rows < 2) return;
  const int count = static_cast<int>(view.variables.size()), room = area.rows - 1;
  const auto variables = by_informativeness(view.variables, count > room);
  scroll = clamped_scroll(scroll, count, count > room ? room - 1 : room);
  const int shown = std::min(count - scroll, count > room ? room - 1 : room);
  const auto hidden =
      view.known_variables > view.variables.size()
          ? std::to_string(view.variables.size()) + " of " + std::to_string(view.known_variables)
          : std::string();
  draw_panel_heading("VARIABLES", hidden, area, canvas);
  for (int i = 0; i < shown; ++i)
    draw_variable(*variables[static_cast<std::size_t>(scroll + i)], area.row + 1 + i, area, canvas);
  if (count <= room) return;
  const int below = count - scroll - shown;
  std::string more = below > 0 ? "and " + std::to_string(below) + " more" : "";
  if (scroll > 0) more += (more.empty() ? "" : ", ") + std::to_string(scroll) + " above";
  canvas.put(area.row + 1 + shown, area.column, more, Style::kDim, area.columns);
}

}  // namespace galilean::monitor::top
