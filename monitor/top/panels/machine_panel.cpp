// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>

#include "monitor/top/panels/break_sign.h"
#include "monitor/top/panels/panels.h"
#include "monitor/top/screen/utf8.h"

namespace galilean::monitor::top {
namespace {

/// A line of the graph: a state, or a condition below the present state.
struct MachineLine {
  const ShownState* state = nullptr;
  const ShownCondition* condition = nullptr;
  bool is_last = false;  ///< the last condition
  bool fires = false;    ///< the first condition that holds
};

std::vector<MachineLine> lines_of(const ShownMachine& machine) {
  std::vector<MachineLine> lines;
  const auto& conditions = machine.conditions;
  const auto fires = std::ranges::find_if(conditions, &ShownCondition::holds);
  for (const auto& state : machine.states) {
    lines.push_back({.state = &state});
    if (!state.current) continue;
    for (auto at = conditions.begin(); at != conditions.end(); ++at)
      lines.push_back(
          {.condition = &*at, .is_last = at + 1 == conditions.end(), .fires = at == fires});
  }
  return lines;
}

bool leads_there(const ShownMachine& machine, const std::string& state) {
  return std::ranges::find(machine.conditions, state, &ShownCondition::to_state) !=
         machine.conditions.end();
}

void draw_state(const ShownMachine& machine, const ShownState& state, int row, const Area& area,
                Canvas& canvas) {
  const Style style = state.current                      ? Style::kCurrent
                      : leads_there(machine, state.name) ? Style::kPlain
                                                         : Style::kDim;
  canvas.put(row, area.column, state.current ? "▶" : " ", style, area.columns);
  canvas.put(row, area.column + 1, sign_of(state.mark),
             state.mark == BreakMark::kNone ? style : style_of(state.mark), area.columns - 1);
  const std::string name = state.chosen ? "[" + state.name + "]" : state.name;
  const int end = canvas.put(row, area.column + 2, name, style, area.columns - 2);
  if (state.before)
    canvas.put(row, end + 1, "← before", Style::kDim, area.column + area.columns - end - 1);
}

/// Draws "├ bumpers[1] = 1  is 0  → back_off".
void draw_condition(const MachineLine& line, int row, const Area& area, Canvas& canvas) {
  const ShownCondition& condition = *line.condition;
  const Style style = line.fires ? Style::kGood : condition.bit ? Style::kPlain : Style::kDim;
  const std::string is = !condition.bit ? "invalid" : *condition.bit ? "is 1" : "is 0";
  const std::string right = (line.fires ? " fires now → " : " → ") + condition.to_state;
  const int room = area.columns - 4;
  const int arrow = std::min(width_of(right), std::max(room / 2, room - width_of(condition.text)));
  canvas.put(row, area.column + 2, line.is_last ? "└" : "├", Style::kDim, room);
  canvas.put(row, area.column + 3, sign_of(condition.mark), style_of(condition.mark), room);
  const int end = canvas.put(row, area.column + 4, condition.text, style, room - arrow);
  const int begin = area.column + area.columns - arrow;
  if (!line.fires && begin - end > width_of(is) + 1) canvas.put(row, end + 2, is, Style::kDim);
  canvas.put(row, begin, right, style, arrow);
}

/// Returns the line to begin with, so that the chosen state or else the present one with its
/// conditions stands in the middle.
int line_wanted_first(const ShownMachine& machine, const std::vector<MachineLine>& lines,
                      int room) {
  const auto find = [&](bool ShownState::*is) {
    return std::ranges::find_if(
        lines, [is](const MachineLine& line) { return line.state && line.state->*is; });
  };
  const auto chosen = find(&ShownState::chosen);
  const auto wanted = chosen == lines.end() ? find(&ShownState::current) : chosen;
  if (wanted == lines.end()) return 0;
  const int below = wanted->state->current ? static_cast<int>(machine.conditions.size()) : 0;
  return static_cast<int>(wanted - lines.begin()) - std::max(0, (room - 1 - below) / 2);
}

}  // namespace

int machine_lines(const View& view) {
  return static_cast<int>(view.machine.states.size() + view.machine.conditions.size()) + 1;
}

std::vector<std::string> draw_machine(const View& view, const Area& area, int& scroll,
                                      Canvas& canvas) {
  std::vector<std::string> states;
  if (area.rows < 2) return states;
  const auto lines = lines_of(view.machine);
  draw_panel_heading("STATES", view.machine.program, area, canvas);
  const int count = static_cast<int>(lines.size()), room = area.rows - 1;
  const int middle = clamped_scroll(line_wanted_first(view.machine, lines, room), count, room);
  const int first = clamped_scroll(middle + scroll, count, room);
  scroll = first - middle;
  for (int i = 0; i < std::min(room, count - first); ++i) {
    const MachineLine& line = lines[static_cast<std::size_t>(first + i)];
    states.push_back(line.state ? line.state->name : std::string());
    if (line.state)
      draw_state(view.machine, *line.state, area.row + 1 + i, area, canvas);
    else
      draw_condition(line, area.row + 1 + i, area, canvas);
  }
  return states;
}

}  // namespace galilean::monitor::top
