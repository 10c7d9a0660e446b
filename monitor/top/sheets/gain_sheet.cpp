// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/top/sheets/gain_sheet.h"

#include <algorithm>
#include <utility>

#include "monitor/top/panels/whole_number.h"
#include "monitor/top/screen/utf8.h"
#include "monitor/top/sheets/answer_words.h"

namespace galilean::monitor::top {
namespace {

constexpr int kFarther = 10;  ///< steps, or lines, at a time

int steps_of(const Press& press) {
  if (press.key == Key::kLeft) return -1;
  if (press.key == Key::kRight) return 1;
  return press.letter == '<' ? -kFarther : press.letter == '>' ? kFarther : 0;
}

int lines_of(const Press& press) {
  return press.key == Key::kPageUp ? -kFarther : press.key == Key::kPageDown ? kFarther : 0;
}

/// Returns where the number stands between its least and its most: "──●────".
std::string slider(double value, const Tunable& tunable, int width) {
  const double span = tunable.max - tunable.min;
  const double part = span > 0 ? (value - tunable.min) / span : 0;
  const int at = whole_number(part * (width - 1), 0, width - 1);
  std::string text;
  for (int i = 0; i < width; ++i) text += i == at ? "●" : "─";
  return text;
}

Sheet::Line line_of_gain(const Tuner& tuner, const Tunable& tunable) {
  constexpr int kName = 36, kValue = 15, kSlider = 12;
  const bool is_moved = tuner.is_moved(tunable);
  const std::string range = exact_text(tunable.min) + " to " + exact_text(tunable.max);
  return {in_column(tunable.schema + " · " + tunable.label, kName) +
              in_column(tuner.text_of(tunable) + " " + tunable.unit, kValue) +
              slider(tuner.value_of(tunable), tunable, kSlider) + "  " +
              (is_moved ? "runs " + exact_text(tunable.value) : range),
          is_moved ? Style::kWarning : Style::kPlain};
}

/// Returns why there is nothing to move.
std::string why_empty(const Reach& reach) {
  if (reach.robots.empty()) return "No robot is heard and in service.";
  if (!reach.program)
    return reach.robots.size() > 1 ? "The robots run different programs. Choose one, and press g."
                                   : reach.robots[0] + " has not told its program yet.";
  if (!reach.catalog) return reach.robots[0] + " has not told its catalog yet.";
  return "The running program writes no gain and no threshold as a number.";
}

}  // namespace

GainSheet::GainSheet(const DashboardModel& model, Pusher& pusher, std::string robot)
    : model_(model), pusher_(pusher), robot_(std::move(robot)) {}

Reach GainSheet::look() {
  Reach reach = reach_of(model_.team(), robot_);
  if (reach.program && reach.catalog) tuner_.show(*reach.program, *reach.catalog);
  return reach;
}

OpenSheet::Turn GainSheet::press(const Press& press) {
  if (press.key == Key::kEscape) return close();
  objection_.clear();
  if (look().program) press_with_numbers(press);
  return stay();
}

void GainSheet::press_with_numbers(const Press& press) {
  const auto& tunables = tuner_.tunables();
  if (tunables.empty()) return;
  const int last = static_cast<int>(tunables.size()) - 1;
  const int chosen = static_cast<int>(chosen_) + direction_of(press) + lines_of(press);
  chosen_ = static_cast<std::size_t>(std::clamp(chosen, 0, last));
  if (const int steps = steps_of(press); steps != 0) tuner_.move(tunables[chosen_], steps);
  if (press.letter == 'x') tuner_.put_back();
  if (press.letter == 'u') undo();
  if (press.key == Key::kEnter) send();
}

std::string GainSheet::hindrance() const {
  if (const auto why = pusher_.hindrance(); !why.empty()) return "Cannot push: " + why;
  return pusher_.report().stage == PushReport::Stage::kPushing
             ? "A push is under way; Enter sends the numbers after it."
             : "";
}

void GainSheet::undo() {
  objection_ = hindrance();
  if (!objection_.empty() || !tuner_.can_undo()) return;
  tuner_.undo();
  send();
}

void GainSheet::send() {
  objection_ = hindrance();
  if (objection_.empty() && !tuner_.has_moves()) objection_ = "No number was moved.";
  if (!objection_.empty()) return;
  PushWish wish{.robots = look().targets};
  wish.files = tuner_.moved_files();
  wish.reason = tuner_.reason();
  wish.replaces = tuner_.program_hash();
  pusher_.push_at_once(wish);
  tuner_.note_sent();
  has_sent_ = true;
}

std::string GainSheet::told() const {
  if (!objection_.empty()) return objection_;
  return has_sent_ ? answer_words(pusher_.report(), model_.replies()) : std::string();
}

Sheet GainSheet::sheet() {
  const Reach reach = look();
  Sheet sheet{.title = "Gains of " + (robot_.empty() ? "the team" : robot_),
              .lines = {},
              .keys = "Esc back"};
  if (const auto words = told(); !words.empty()) sheet.title += ": " + words;
  const auto& tunables = tuner_.tunables();
  if (!reach.program || !reach.catalog || tunables.empty()) {
    sheet.lines = {{why_empty(reach)}};
    return sheet;
  }
  for (const auto& tunable : tunables) sheet.lines.push_back(line_of_gain(tuner_, tunable));
  sheet.chosen = std::min(chosen_, tunables.size() - 1);
  sheet.keys = "← → < > move  Enter sends  x as it runs  u undo  Esc back";
  return sheet;
}

}  // namespace galilean::monitor::top
