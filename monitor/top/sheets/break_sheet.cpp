// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/top/sheets/break_sheet.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "monitor/orders/break_words.h"
#include "monitor/team/break_reason.h"
#include "monitor/top/model/break_marks.h"
#include "monitor/top/panels/break_sign.h"

namespace galilean::monitor::top {
namespace {

namespace kinds = msg::BreakPoint_Constants;

constexpr std::size_t kKindColumns = 11;

/// Returns whether it is this lock at which the robot waits.
bool waits_at(const msg::Breaks& breaks, const msg::BreakPoint& point) {
  const auto fits = [](const std::string& name, const std::string& wanted) {
    return wanted.empty() || name == wanted;
  };
  return point.kind == kinds::LOCK && waits_at_lock(breaks) &&
         fits(breaks.waits_at_from, point.from_state) && fits(breaks.waits_at_to, point.to_state);
}

/// Returns "stop team  ", as wide as its column.
std::string column_of(std::uint8_t kind) {
  std::string words = msg::name_of(kinds::kAll, kind);
  std::ranges::replace(words, '_', ' ');
  words.resize(std::max(words.size(), kKindColumns), ' ');
  return words;
}

/// Returns the next kind in the order of the IDL; after the last one, and after an unknown one, the
/// first.
std::uint8_t kind_after(std::uint8_t kind) {
  const auto found = std::ranges::find(kinds::kAll, kind, &msg::NamedConstant::value);
  const bool has_next = found != std::end(kinds::kAll) && found + 1 != std::end(kinds::kAll);
  return has_next ? (found + 1)->value : std::begin(kinds::kAll)->value;
}

Sheet::Line line_of(const msg::Breaks& breaks, const msg::BreakPoint& point) {
  const BreakMark mark = mark_of(point.kind);
  const bool waits = waits_at(breaks, point);
  return {sign_of(mark) + (" " + column_of(point.kind)) + place_of(point) +
              (waits ? "  the robot waits here" : ""),
          waits ? Style::kWarning : Style::kPlain};
}

}  // namespace

BreakSheet::BreakSheet(const DashboardModel& model, Steering& steering, std::string robot,
                       bool over_past)
    : model_(model), steering_(steering), robot_(std::move(robot)), over_past_(over_past) {
  const msg::Breaks* told = breaks();
  if (!told || told->points.empty()) return;
  const auto lock = std::ranges::find_if(
      told->points, [&](const msg::BreakPoint& point) { return waits_at(*told, point); });
  const bool waits = lock != told->points.end();
  choose(waits ? static_cast<std::size_t>(lock - told->points.begin()) : 0);
}

const msg::Breaks* BreakSheet::breaks() const {
  const Robot* robot = model_.team().find(robot_);
  return robot && robot->breaks ? &*robot->breaks : nullptr;
}

const msg::BreakPoint* BreakSheet::chosen() const {
  const msg::Breaks* told = breaks();
  if (!told) return nullptr;
  const auto found = std::ranges::find_if(told->points, [&](const msg::BreakPoint& point) {
    return point.from_state == chosen_.from_state && point.to_state == chosen_.to_state;
  });
  return found == told->points.end() ? nullptr : &*found;
}

void BreakSheet::choose(std::size_t line) {
  const auto& points = breaks()->points;
  line_ = std::min(line, points.size() - 1);
  chosen_ = points[line_];
}

OpenSheet::Turn BreakSheet::press(const Press& press) {
  if (press.key == Key::kEscape || press.letter == 'B') return close();
  const int line = static_cast<int>(line_) + direction_of(press);
  const bool moves = direction_of(press) != 0 && breaks() && !breaks()->points.empty();
  if (moves) choose(static_cast<std::size_t>(std::max(line, 0)));
  if (press.key == Key::kEnter) press_letter('l');
  if (press.key == Key::kLetter) press_letter(press.letter);
  return stay();
}

void BreakSheet::press_letter(char letter) {
  if (letter == 'C') return steering_.order_breaks(robot_, "clear", {});
  // What is gone is not changed, nor what has come into its line: the next picture chooses that.
  if (const msg::BreakPoint* point = chosen()) change(*point, letter);
}

void BreakSheet::change(const msg::BreakPoint& point, char letter) {
  if (letter == 'x') steering_.order_breaks(robot_, "remove", {point});
  if (letter == 't')
    steering_.order_breaks(robot_, "set",
                           {{point.from_state, point.to_state, kind_after(point.kind)}});
  if (letter != 'l') return;
  // A robot that waits is let through from where it waits; another lock of the same state stays.
  const msg::Breaks& told = *breaks();
  const msg::BreakPoint waited{told.waits_at_from, told.waits_at_to, point.kind};
  steering_.order_breaks(robot_, "let_through", {waits_at(told, point) ? waited : point});
}

Sheet BreakSheet::sheet() {
  const std::string title = (over_past_ ? "Now: break points of " : "Break points of ") + robot_;
  Sheet sheet{.title = title, .lines = {}, .keys = "Esc back"};
  const msg::Breaks* told = breaks();
  if (!told) {
    sheet.lines = {{robot_ + " has told nothing about break points."}};
    return sheet;
  }
  for (const auto& point : told->points) sheet.lines.push_back(line_of(*told, point));
  if (told->points.empty()) {
    sheet.lines = {{"It has none. J and K choose a state, and b makes it stop on entering that."}};
    return sheet;
  }
  const msg::BreakPoint* point = chosen();
  choose(point ? static_cast<std::size_t>(point - told->points.data()) : line_);
  sheet.chosen = line_;
  sheet.keys = "x remove  t stop, stop team or lock  l let through  C remove all  Esc back";
  return sheet;
}

}  // namespace galilean::monitor::top
