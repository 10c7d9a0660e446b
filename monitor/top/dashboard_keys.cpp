// SPDX-License-Identifier: BSD-3-Clause
#include <cctype>
#include <utility>

#include "core/cut_text.h"
#include "monitor/top/dashboard.h"
#include "monitor/top/sheets/help_sheet.h"
#include "monitor/top/sheets/push_sheet.h"

namespace galilean::monitor::top {
namespace {

constexpr Duration kStep = std::chrono::seconds(1);
constexpr int kPage = 10;

}  // namespace

bool Dashboard::press(const Press& press) {
  if (press.key == Key::kNone) return true;
  is_settled_ = is_settled_ || !choice_.robot.empty();
  // Whatever is asked or shown, STOP ALL works.
  if (stops_all(press)) return steering_.stop_all(), true;
  if (types()) return press_with_text(press), true;
  if (mode_ == Mode::kQuestion) return answer(press.letter), true;
  if (press.letter == 'q') return false;
  if (mode_ == Mode::kSheet)
    press_with_sheet(press);
  else if (press.key == Key::kLetter)
    press_letter(press.letter);
  else
    press_with_team(press);
  return true;
}

bool Dashboard::types() const noexcept {
  return mode_ == Mode::kFilter || mode_ == Mode::kFile || mode_ == Mode::kReason;
}

bool Dashboard::stops_all(const Press& press) const noexcept {
  if (press.key == Key::kStop) return true;
  const bool is_text = types() && has_typed_ && !is_too_small_;
  return press.letter == '.' && !is_text;
}

std::string& Dashboard::typed() {
  if (mode_ == Mode::kFile) return file_;
  if (mode_ == Mode::kReason) return reason_;
  return tab_ == Tab::kVariables ? choice_.variable_filter : choice_.robot_filter;
}

void Dashboard::press_with_text(const Press& press) {
  has_typed_ = true;
  std::string& text = typed();
  if (press.key == Key::kLetter) text += press.letter;
  if (press.key == Key::kBackspace && !text.empty())
    text.resize(cut_text(text, text.size() - 1).size());
  const Mode mode = mode_;
  if (press.key == Key::kEnter || press.key == Key::kEscape) mode_ = Mode::kTeam;
  if (press.key == Key::kEscape && mode == Mode::kFilter) text.clear();
  if (press.key == Key::kEnter && mode == Mode::kReason) return take_over();
  if (press.key != Key::kEnter || mode != Mode::kFile || file_.empty()) return;
  wish_.file = file_;
  open(std::make_unique<PushSheet>(pusher_, std::move(wish_)));
}

void Dashboard::press_with_sheet(const Press& press) {
  auto turn = sheet_->press(press);
  if (turn.stays) return;
  mode_ = Mode::kTeam;
  sheet_.reset();
  if (turn.next) open(std::move(turn.next));
}

void Dashboard::answer(char letter) {
  mode_ = Mode::kTeam;
  const auto yes = std::exchange(yes_, nullptr);
  if (letter == 'y' || letter == 'Y') yes();
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
      return go_to(history_.begin());
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
      choice_.state.clear();
      return steering_.end_stop_report();
    default:
      return;
  }
}

void Dashboard::press_letter(char letter) {
  if (letter >= '1' && letter <= '9') return choose(static_cast<std::size_t>(letter - '1'));
  const bool to_all = std::isupper(static_cast<unsigned char>(letter));
  switch (std::tolower(static_cast<unsigned char>(letter))) {
    case 'h':
      return steering_.say(Operator::Word::kHold, shown_robot(), to_all);
    case 'r':
      return ask_to_resume(to_all);
    case 's':
      return steering_.say(Operator::Word::kStart, shown_robot(), to_all);
    case 'a':
      return to_all ? acknowledge_shown() : acknowledge_first();
    case 'j':
      return to_all ? move_in_machine(+1) : move(+1);
    case 'k':
      return to_all ? move_in_machine(-1) : move(-1);
    case 'b':
      return to_all ? open_breaks() : toggle_break_point();
    case 'd':
      return to_all ? void() : ask_about_service();
    case 'n':
      return steering_.say(Operator::Word::kStep, shown_robot(), to_all);
    case 'l':
      return go_to({});
    case 'm':
      return to_all ? insist() : take_turns();
    case 'p':
      return begin_push(false, to_all);
    case 'u':
      return begin_push(true, to_all);
    case 'g':
      return open_gains(to_all);
    case 'w':
      return open_history(to_all);
    case '/':
      return begin_text(Mode::kFilter);
    case '?':
      return open(std::make_unique<HelpSheet>());
    default:
      return;
  }
}

}  // namespace galilean::monitor::top
