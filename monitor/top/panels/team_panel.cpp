// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include "core/plural.h"
#include "monitor/top/panels/panels.h"
#include "monitor/top/panels/whole_number.h"

namespace galilean::monitor::top {
namespace {

std::string one_decimal(double number, const char* unit) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), number < 99.95 ? "%.1f%s" : "%.0f%s", number, unit);
  return text.data();
}

std::string microseconds(double time_us) {
  return std::to_string(whole_number(time_us, 0, 1'000'000)) + "µ";
}

std::string percent(double fraction) {
  return std::to_string(whole_number(fraction * 100, 0, 100)) + "%";
}

std::string clock_text(double seconds) {
  std::array<char, 32> text{};
  constexpr int kMost_s = 999 * 60 + 59;
  const int whole = whole_number(std::floor(seconds), 0, kMost_s);
  std::snprintf(text.data(), text.size(), "%02d:%02d", whole / 60, whole % 60);
  return text.data();
}

constexpr const char* kNotKnown = "–";
constexpr int kLetters = 3;  ///< cells for a robot's letter

/// The first column of each field of the table. Names, states and programs share the width beyond
/// 80 cells.
struct Columns {
  int name = 3 + kLetters, state, for_s, program, hash, age, tick, lowest;

  explicit Columns(int width) {
    const int spare = std::max(0, width - 80);
    state = name + 9 + spare / 4;
    for_s = state + 19 + spare / 4;
    program = for_s + 7;
    hash = program + 13 + spare / 4;
    age = hash + 9;
    tick = age + 6;
    lowest = tick + 6;
  }
};

std::string flags(const ShownRobot& robot) {
  const RobotStatus& status = robot.status;
  std::string text;
  if (!robot.steered_by.empty()) text += " (" + robot.steered_by + " steers)";
  if (status.out_of_service) text += " out of service";
  if (status.held) text += robot.is_stopped ? " stopped" : " held";
  if (robot.waits) text += " waits";
  if (status.in_probation) text += " on probation";
  if (status.drifting) text += " other program";
  return text;
}

Style health_style(const RobotStatus& status) {
  if (status.health == Health::kSilent) return Style::kDim;
  return status.health == Health::kTroubled ? Style::kWarning : Style::kPlain;
}

void draw_robot(const ShownRobot& robot, bool chosen, int row, int width, Canvas& canvas) {
  const RobotStatus& status = robot.status;
  const Columns at(width);
  const Style style = health_style(status);
  canvas.put(row, 0, chosen ? "▶" : " ", Style::kBold);
  if (robot.has_unseen_alarm || !status.problems.empty()) canvas.put(row, 1, "!", Style::kAlarm);
  const bool silent = status.health == Health::kSilent;
  canvas.put(row, 2, robot.letter, silent ? Style::kDim : robot_style(robot.number), kLetters);
  canvas.put(row, at.name, status.name, chosen ? Style::kBold : style, at.state - at.name - 1);
  canvas.put(row, at.state, (status.replayed ? "replay: " : "") + status.state + flags(robot),
             status.held || robot.waits ? Style::kWarning : style, at.for_s - at.state - 1);
  canvas.put_right(row, at.program - 1,
                   status.has_state ? one_decimal(status.in_state_s, "s") : kNotKnown, style);
  const Style program = status.drifting ? Style::kWarning : style;
  canvas.put(row, at.program, status.program_name, program, at.hash - at.program - 1);
  canvas.put(row, at.hash, status.program_hash, program, 8);
  canvas.put_right(row, at.tick - 1, lasting(status.age_s), style);
  canvas.put_right(row, at.lowest - 1,
                   status.has_state ? microseconds(status.tick_time_max_us) : kNotKnown,
                   status.overruns > 0 ? Style::kWarning : style);
  const bool is_sure_known = !status.least_certain.empty();
  const int end = canvas.put(row, at.lowest,
                             is_sure_known ? percent(status.lowest_certainty) : kNotKnown, style);
  constexpr int kWorthReading = 6;
  if (width - end > kWorthReading)
    canvas.put(row, end + 1, status.least_certain, Style::kDim, width - end - 1);
}

void draw_heads(int row, int width, Canvas& canvas) {
  const Columns at(width);
  canvas.put(row, at.name, "ROBOT", Style::kHeading);
  canvas.put(row, at.state, "STATE", Style::kHeading);
  canvas.put_right(row, at.program - 1, "FOR", Style::kHeading);
  canvas.put(row, at.program, "PROGRAM", Style::kHeading);
  canvas.put_right(row, at.tick - 1, "AGE", Style::kHeading);
  canvas.put_right(row, at.lowest - 1, "TICK", Style::kHeading);
  canvas.put(row, at.lowest, "LEAST SURE", Style::kHeading, width - at.lowest);
}

}  // namespace

void draw_title(const View& view, Canvas& canvas) {
  std::string robots = plural(view.known_robots, "robot");
  if (view.robots.size() < view.known_robots)
    robots = std::to_string(view.robots.size()) + " of " + robots;
  int column = canvas.put(0, 0, robots, Style::kBold);
  if (!view.score) return;
  const msg::Score& score = *view.score;
  column = canvas.put(0, column, "  " + score.scenario + " " + score.phase, Style::kPlain);
  column = canvas.put(0, column, "  " + clock_text(score.remaining_s) + " left", Style::kBold);
  column = canvas.put(
      0, column, "  " + std::to_string(score.deposited) + " of " + plural(score.pieces, "piece"));
  column = canvas.put(0, column, "  " + one_decimal(score.points, " points"), Style::kBold);
  canvas.put(0, column, "  " + plural(score.collisions, "collision"));
}

int draw_team(const View& view, const Area& area, std::size_t& first_robot, Canvas& canvas) {
  draw_heads(area.row, area.columns, canvas);
  const int room = area.rows - 1, count = static_cast<int>(view.robots.size());
  const int shown = count <= room ? count : std::max(0, room - 1);
  // The lines are scrolled so that the chosen robot always shows.
  const int first =
      std::clamp(static_cast<int>(view.chosen) - shown + 1, 0, std::max(0, count - shown));
  first_robot = static_cast<std::size_t>(first);
  for (int i = 0; i < shown; ++i) {
    const auto number = static_cast<std::size_t>(first + i);
    draw_robot(view.robots[number], number == view.chosen, area.row + 1 + i, area.columns, canvas);
  }
  if (shown == count) return 1 + shown;
  canvas.put(area.row + 1 + shown, Columns(area.columns).name,
             "and " + std::to_string(count - shown) + " more", Style::kDim);
  return 2 + shown;
}

std::vector<AlarmLine> draw_alarms(const View& view, const Area& area, Canvas& canvas) {
  const auto most = static_cast<std::size_t>(std::max(area.rows, 0));
  auto lines = alarm_lines(view.alarms, view.now, most);
  if (lines.size() > most) lines.resize(most);
  int row = area.row;
  for (const auto& line : lines) {
    const Style style = line.seen || line.over ? Style::kDim : Style::kAlarm;
    const std::string sign = std::string(line.over ? "✓ " : "! ") + (view.is_past ? "now: " : "");
    canvas.put(row++, area.column, sign + line.text + (line.seen ? "  (seen)" : ""), style,
               area.columns);
  }
  return lines;
}

}  // namespace galilean::monitor::top
