// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>

#include "monitor/top/panels/panels.h"

namespace galilean::monitor::top {
namespace {

/// Returns the first line to show if `room` of `count` lines fit and the line `wanted` must show.
int first_shown(int count, int room, int wanted) {
  return std::clamp(wanted - room / 2, 0, std::max(0, count - room));
}

void draw_bar(int row, int column, int width, double certainty, Style style, Canvas& canvas) {
  const int full = std::clamp(static_cast<int>(std::lround(certainty * width)), 0, width);
  for (int i = 0; i < width; ++i)
    canvas.set(row, column + i, i < full ? U'█' : U'·', i < full ? style : Style::kDim);
}

Style bar_style(double certainty) {
  constexpr double kLow = 0.25, kHalf = 0.5;
  return certainty < kLow ? Style::kAlarm : certainty < kHalf ? Style::kWarning : Style::kBasket;
}

void draw_variable(const ShownVariable& variable, int row, const Area& area, Canvas& canvas) {
  constexpr int kBar = 6, kPercent = 5, kName = 15;
  const Style style = variable.certainty > 0 ? Style::kPlain : Style::kDim;
  canvas.put(row, area.column, variable.name, style, kName);
  const int bar = area.column + kName + 1;
  draw_bar(row, bar, kBar, variable.certainty, bar_style(variable.certainty), canvas);
  canvas.put_right(row, bar + kBar + kPercent,
                   std::to_string(std::lround(variable.certainty * 100)) + "%", style);
  canvas.put(row, bar + kBar + kPercent + 1, variable.value, style,
             area.columns - (kName + 1 + kBar + kPercent + 1));
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
  std::stable_sort(order.begin(), order.end(),
                   [&](const auto* a, const auto* b) { return rank(a) < rank(b); });
  return order;
}

}  // namespace

void draw_states(const View& view, const Area& area, Canvas& canvas) {
  if (area.rows < 2) return;
  canvas.put(area.row, area.column, "STATES", Style::kHeading, area.columns);
  const auto current =
      std::find_if(view.states.begin(), view.states.end(), [](const auto& s) { return s.current; });
  const int count = static_cast<int>(view.states.size()), room = area.rows - 1;
  const int wanted = static_cast<int>(current - view.states.begin());
  const int first = first_shown(count, room, wanted);
  for (int i = 0; i < std::min(room, count); ++i) {
    const ShownState& state = view.states[static_cast<std::size_t>(first + i)];
    canvas.put(area.row + 1 + i, area.column, (state.current ? "▶ " : "  ") + state.name,
               state.current ? Style::kCurrent : Style::kPlain, area.columns);
  }
}

void draw_variables(const View& view, const Area& area, Canvas& canvas) {
  if (area.rows < 2) return;
  canvas.put(area.row, area.column, "VARIABLES", Style::kHeading, area.columns);
  const int count = static_cast<int>(view.variables.size()), room = area.rows - 1;
  const int shown = count <= room ? count : room - 1;
  const auto variables = by_informativeness(view.variables, count > room);
  for (int i = 0; i < shown; ++i)
    draw_variable(*variables[static_cast<std::size_t>(i)], area.row + 1 + i, area, canvas);
  if (shown < count)
    canvas.put(area.row + 1 + shown, area.column, "and " + std::to_string(count - shown) + " more",
               Style::kDim, area.columns);
}

}  // namespace galilean::monitor::top
