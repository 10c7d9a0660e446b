// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/top/dashboard.h"

#include <algorithm>
#include <utility>

#include "monitor/top/panels/help.h"

namespace galilean::monitor::top {
namespace {

constexpr Duration kNoticeShown = std::chrono::seconds(4);
constexpr Duration kStep = std::chrono::seconds(1);
constexpr int kPage = 10, kWheel = 3;

Sheet sheet_of(const PushReport& report, std::string keys, int scroll) {
  return {report.title, report.lines, std::move(keys), scroll};
}

}  // namespace

Dashboard::Dashboard(Parts parts, std::string chosen)
    : parts_(std::move(parts)), help_(help_sheet()) {
  choice_.robot = std::move(chosen);
  is_settled_ = !choice_.robot.empty();
}

void Dashboard::choose(std::size_t number) {
  const View shown = view();
  if (number < shown.robots.size()) choice_.robot = shown.robots[number].status.name;
  scrolls_ = {};
}

void Dashboard::move(int step) {
  const View shown = view();
  const auto now = static_cast<int>(shown.chosen);
  if (now + step >= 0) choose(static_cast<std::size_t>(now + step));
}

void Dashboard::scroll(Panel panel, int lines) {
  if (panel == Panel::kTeam) return move(lines > 0 ? 1 : -1);
  if (panel == Panel::kMachine) scrolls_.machine += lines;
  if (panel == Panel::kVariables) scrolls_.variables += lines;
  if (panel == Panel::kWhy) scrolls_.why += lines;
}

void Dashboard::click(const Press& press) {
  const auto at = std::ranges::find_if(regions_, [&](const Region& region) {
    return region.area.contains(press.row, press.column);
  });
  if (at == regions_.end()) return;
  if (press.key == Key::kWheelUp) return scroll(at->panel, -kWheel);
  if (press.key == Key::kWheelDown) return scroll(at->panel, kWheel);
  if (at->robot.empty()) return;
  choice_.robot = at->robot;
  scrolls_ = {};
}

void Dashboard::go_to(std::optional<Time> instant) {
  const Time first = parts_.history.begin();
  if (instant && *instant >= parts_.clock.now()) instant.reset();
  instant_ = instant ? std::optional(std::max(*instant, first)) : std::nullopt;
  past_ = instant_ ? std::make_unique<Past>(parts_.history, *instant_) : nullptr;
}

void Dashboard::go_back(Duration step) {
  go_to(instant_.value_or(parts_.clock.now()) - step);
}

void Dashboard::acknowledge_first() {
  if (!shown_alarms_.empty()) board_.acknowledge(shown_alarms_[0].keys);
}

void Dashboard::acknowledge_shown() {
  for (const auto& line : shown_alarms_) board_.acknowledge(line.keys);
}

std::string& Dashboard::typed() {
  if (mode_ == Mode::kFile) return file_;
  return tab_ == Tab::kVariables ? choice_.variable_filter : choice_.robot_filter;
}

bool Dashboard::types() const noexcept {
  return mode_ == Mode::kFilter || mode_ == Mode::kFile;
}

bool Dashboard::stops_all(const Press& press) const noexcept {
  if (press.key == Key::kStop) return true;
  const bool is_text = types() && has_typed_ && !is_too_small_;
  return press.letter == '.' && !is_text;
}

void Dashboard::begin_text(Mode mode) {
  mode_ = mode;
  has_typed_ = false;
}

void Dashboard::press_with_text(const Press& press) {
  has_typed_ = true;
  std::string& text = typed();
  if (press.key == Key::kLetter) text += press.letter;
  if (press.key == Key::kBackspace && !text.empty()) text.pop_back();
  const Mode mode = mode_;
  if (press.key == Key::kEnter || press.key == Key::kEscape) mode_ = Mode::kTeam;
  if (press.key == Key::kEscape && mode == Mode::kFilter) text.clear();
  if (press.key == Key::kEnter && mode == Mode::kFile && !file_.empty()) check(file_);
}

void Dashboard::press_with_sheet(const Press& press) {
  const bool up = press.key == Key::kUp || press.key == Key::kWheelUp;
  const bool down = press.key == Key::kDown || press.key == Key::kWheelDown;
  if (up || down)
    help_.scroll += up ? -1 : 1;
  else if (press.key != Key::kOther)
    mode_ = Mode::kTeam;
}

void Dashboard::press_with_team(const Press& press) {
  const Panel scrolled = tab_ == Tab::kMachine ? Panel::kMachine
                         : tab_ == Tab::kWhy   ? Panel::kWhy
                                               : Panel::kVariables;
  switch (press.key) {
    case Key::kUp:
      return move(-1);
    case Key::kDown:
      return move(+1);
    case Key::kLeft:
      return go_back(kStep);
    case Key::kRight:
      return instant_ ? go_back(-kStep) : void();
    case Key::kHome:
      return go_to(parts_.history.begin());
    case Key::kEnd:
      return go_to({});
    case Key::kPageUp:
      return scroll(scrolled, -kPage);
    case Key::kPageDown:
      return scroll(scrolled, kPage);
    case Key::kTab:
      tab_ = after(tab_);
      return;
    case Key::kClick:
    case Key::kWheelUp:
    case Key::kWheelDown:
      return click(press);
    case Key::kEscape:
      choice_.robot_filter.clear();
      choice_.variable_filter.clear();
      stop_order_.reset();
      return;
    default:
      return;
  }
}

bool Dashboard::press(const Press& press) {
  if (press.key == Key::kNone) return true;
  is_settled_ = is_settled_ || !choice_.robot.empty();
  // Whatever is asked or shown, STOP ALL works.
  if (stops_all(press)) return stop_all(), true;
  if (types()) return press_with_text(press), true;
  if (mode_ == Mode::kQuestion) return answer(press.letter), true;
  if (press.letter == 'q') return false;
  if (mode_ == Mode::kHelp)
    press_with_sheet(press);
  else if (mode_ == Mode::kPush)
    press_with_push(press);
  else if (press.key == Key::kLetter)
    return press_letter(press.letter);
  else
    press_with_team(press);
  return true;
}

View Dashboard::view() const {
  const DashboardModel& model = past_ ? past_->model() : parts_.model;
  const Clock& clock = past_ ? past_->clock() : parts_.clock;
  return make_view({model, clock, parts_.model.identities(), &parts_.history, &board_,
                    past_ ? &parts_.clock : nullptr},
                   choice_);
}

Surroundings Dashboard::surroundings() const {
  const Time now = parts_.clock.now();
  Surroundings around{.tab = tab_, .scrolls = scrolls_};
  if (stop_order_)
    around.banner = "STOP ALL: " + stop_sentence(stop_order_->progress(parts_.model.team(), now));
  if (instant_)
    around.remark = lasting(to_seconds(now - *instant_)) + " ago (l: now)";
  else if (!parts_.pusher.hindrance().empty())
    around.remark = "cannot push";
  if (mode_ == Mode::kQuestion) around.footer = question_ + " y / n   . STOP ALL";
  if (mode_ == Mode::kFile)
    around.footer = "Push which file? " + file_ + "_  Enter, Esc, Ctrl-X STOP ALL";
  if (mode_ == Mode::kFilter)
    around.footer = std::string(tab_ == Tab::kVariables ? "Variables" : "Robots") + " with: " +
                    (tab_ == Tab::kVariables ? choice_.variable_filter : choice_.robot_filter) +
                    "_  Enter keeps it, Esc shows all, Ctrl-X STOP ALL";
  if (around.footer.empty() && !notice_.empty() && now - noticed_ < kNoticeShown)
    around.footer = notice_;
  return around;
}

Canvas Dashboard::draw(int columns, int rows) {
  Screen screen = lay_out(view(), surroundings(), columns, rows);
  regions_ = std::move(screen.regions);
  shown_alarms_ = std::move(screen.alarms);
  is_too_small_ = columns < kLeastColumns || rows < kLeastRows;
  if (!is_too_small_) scrolls_ = screen.scrolls;
  if (mode_ == Mode::kHelp) lay_over(help_, screen.canvas);
  if (mode_ == Mode::kPush) {
    const PushReport report = parts_.pusher.report();
    Sheet sheet = sheet_of(report, push_keys(report), push_scroll_);
    lay_over(sheet, screen.canvas);
    push_scroll_ = sheet.scroll;
  }
  return std::move(screen.canvas);
}

}  // namespace galilean::monitor::top
