// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/top/panels/layout.h"

#include <algorithm>
#include <utility>

#include "monitor/top/panels/panels.h"
#include "monitor/top/screen/utf8.h"

namespace galilean::monitor::top {
namespace {

constexpr const char* kKeys =
    "h hold  r resume  . STOP ALL  p push  Tab panels  / filter  ? keys  q quit";
constexpr int kGap = 2;

/// The panels of one screen, drawn one after another.
class Page {
 public:
  Page(const View& view, const Surroundings& around, int columns, int rows)
      : view_(view), around_(around), screen_{Canvas(columns, rows), {}, around.scrolls, {}} {}

  Screen draw() {
    Canvas& canvas = screen_.canvas;
    draw_title(view_, canvas);
    if (!around_.remark.empty())
      canvas.put_right(0, canvas.columns(), " " + around_.remark, Style::kWarning);
    draw_footer();
    int row = 1;
    if (!around_.banner.empty()) {
      canvas.fill({row, 0, 1, canvas.columns()}, Style::kStop);
      canvas.put(row++, 1, around_.banner, Style::kStop, canvas.columns() - 1);
    }
    if (view_.robots.empty()) {
      canvas.put(row + 1, 0, "No robot has been heard yet.");
      canvas.put(row + 2, 0,
                 "Check that robots run in the same DDS domain (--domain or ROS_DOMAIN_ID).");
      return std::move(screen_);
    }
    row = draw_upper(row);
    draw_lower({row, 0, canvas.rows() - 1 - row, canvas.columns()});
    return std::move(screen_);
  }

 private:
  void draw_footer() {
    Canvas& canvas = screen_.canvas;
    if (around_.footer.empty())
      canvas.put(canvas.rows() - 1, 0, kKeys, Style::kDim);
    else
      canvas.put(canvas.rows() - 1, 0, around_.footer, Style::kBold);
  }

  /// Draws the team and the alarms. Returns the row below them.
  int draw_upper(int row) {
    Canvas& canvas = screen_.canvas;
    const int columns = canvas.columns(), most_robots = std::max(3, canvas.rows() / 3);
    std::size_t first = 0;
    const int used = draw_team(view_, {row, 0, most_robots, columns}, first, canvas);
    for (int i = 1; i < used && first < view_.robots.size(); ++i, ++first)
      screen_.regions.push_back(
          {Panel::kTeam, {row + i, 0, 1, columns}, view_.robots[first].status.name});
    row += used;
    const Area room{row, 0, std::max(2, canvas.rows() / 12), columns};
    screen_.alarms = draw_alarms(view_, room, canvas);
    row += static_cast<int>(screen_.alarms.size());
    return draw_break_reason(view_, {row, 0, 1, columns}, canvas) ? row + 1 : row;
  }

  void draw_lower(const Area& area) {
    constexpr int kThreeColumns = 180;
    if (around_.tab == Tab::kMap) return put(Panel::kMap, area);
    const int left = area.columns * 2 / 5;
    put(Panel::kMap, {area.row, area.column, area.rows, left});
    const Area rest{area.row, left + kGap, area.rows, area.columns - left - kGap};
    if (around_.tab == Tab::kMachine) return put(Panel::kMachine, rest);
    if (around_.tab == Tab::kVariables) return put(Panel::kVariables, rest);
    if (around_.tab == Tab::kWhy) return put(Panel::kWhy, rest);
    if (area.columns < kThreeColumns) return stack(rest);
    const int middle = rest.columns * 2 / 5;
    stack_machine_and_why({rest.row, rest.column, rest.rows, middle});
    put(Panel::kVariables,
        {rest.row, rest.column + middle + kGap, rest.rows, rest.columns - middle - kGap});
  }

  /// Draws the machine above the variables, and the reasons below them if there is room.
  void stack(const Area& area) {
    constexpr int kLeastForWhy = 26, kLeastWhy = 7;
    const int why = area.rows >= kLeastForWhy ? std::max(kLeastWhy, area.rows / 4) : 0;
    const int rows = area.rows - why;
    // The machine gets the rows that the variables do not need.
    const int left_over = rows - 1 - static_cast<int>(view_.variables.size());
    const int machine = std::min(machine_lines(view_), std::max({4, rows / 2, left_over}));
    put(Panel::kMachine, {area.row, area.column, machine, area.columns});
    put(Panel::kVariables, {area.row + machine, area.column, rows - machine, area.columns});
    put(Panel::kWhy, {area.row + rows, area.column, why, area.columns});
  }

  void stack_machine_and_why(const Area& area) {
    const int machine = std::min(machine_lines(view_), std::max(4, area.rows * 3 / 5));
    put(Panel::kMachine, {area.row, area.column, machine, area.columns});
    put(Panel::kWhy, {area.row + machine, area.column, area.rows - machine, area.columns});
  }

  void put(Panel panel, const Area& area) {
    if (area.rows <= 0 || area.columns <= 0) return;
    Scrolls& scrolls = screen_.scrolls;
    // A click takes the first region that it hits, so the lines of a panel come before the panel.
    if (panel == Panel::kMachine) put_states(area);
    screen_.regions.push_back({panel, area});
    switch (panel) {
      case Panel::kMap:
        return draw_map(view_, area, screen_.canvas);
      case Panel::kVariables:
        return draw_variables(view_, area, scrolls.variables, screen_.canvas);
      case Panel::kWhy:
        return draw_why(view_, area, scrolls.why, screen_.canvas);
      case Panel::kMachine:
      case Panel::kTeam:
        break;
    }
  }

  void put_states(const Area& area) {
    int row = area.row;
    for (auto& state : draw_machine(view_, area, screen_.scrolls.machine, screen_.canvas)) {
      ++row;
      if (!state.empty())
        screen_.regions.push_back(
            {Panel::kMachine, {row, area.column, 1, area.columns}, {}, std::move(state)});
    }
  }

  const View& view_;
  const Surroundings& around_;
  Screen screen_;
};

Screen too_small(const std::string& footer, int columns, int rows) {
  Screen screen{Canvas(columns, rows)};
  screen.canvas.put(0, 0, "This window is too small:", Style::kBold);
  screen.canvas.put(1, 0,
                    std::to_string(columns) + " × " + std::to_string(rows) + " cells, needs " +
                        std::to_string(kLeastColumns) + " × " + std::to_string(kLeastRows) + ".");
  screen.canvas.put(2, 0, ". stops all robots, Ctrl-C quits.");
  screen.canvas.put(4, 0, footer, Style::kStop);
  return screen;
}

}  // namespace

Tab after(Tab tab) noexcept {
  return tab == Tab::kMap ? Tab::kAll : static_cast<Tab>(static_cast<int>(tab) + 1);
}

Screen lay_out(const View& view, const Surroundings& around, int columns, int rows) {
  if (columns < kLeastColumns || rows < kLeastRows)
    return too_small(around.banner.empty() ? around.footer : around.banner, columns, rows);
  return Page(view, around, columns, rows).draw();
}

}  // namespace galilean::monitor::top
