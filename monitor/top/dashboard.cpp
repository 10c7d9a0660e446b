// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/top/dashboard.h"

#include <cctype>

#include "monitor/top/panels/layout.h"

namespace galilean::monitor::top {
namespace {

constexpr Duration kNoticeShown = std::chrono::seconds(4);

std::string words(Operator::Word word) {
  switch (word) {
    case Operator::Word::kHold:
      return "hold";
    case Operator::Word::kResume:
      return "resume";
    case Operator::Word::kStart:
      break;
  }
  return "start";
}

}  // namespace

void Dashboard::choose(std::size_t number) {
  const auto& robots = model_.team().robots();
  if (number < robots.size()) chosen_ = std::next(robots.begin(), static_cast<long>(number))->first;
}

void Dashboard::move(int step) {
  const auto& robots = model_.team().robots();
  const auto at = robots.find(chosen_);
  const long now = at == robots.end() ? 0 : std::distance(robots.begin(), at);
  if (now + step >= 0) choose(static_cast<std::size_t>(now + step));
}

void Dashboard::say(Operator::Word word, bool to_all) {
  const View view = make_view(model_, clock_, chosen_);
  if (view.robots.empty()) return;
  const std::string& robot = view.robots[view.chosen].status.name;
  const bool sent = speaker_.say(word, to_all ? std::vector<std::string>{} : std::vector{robot});
  notice_ =
      (sent ? "told " : "could not tell ") + (to_all ? "all robots" : robot) + " to " + words(word);
  noticed_ = clock_.now();
}

bool Dashboard::press(const Press& press) {
  if (press.key == Key::kNone) return true;
  if (std::exchange(help_, false)) return press.letter != 'q';
  if (press.key == Key::kUp) move(-1);
  if (press.key == Key::kDown) move(+1);
  const char letter = press.letter;
  if (letter >= '1' && letter <= '9') choose(static_cast<std::size_t>(letter - '1'));
  const bool to_all = std::isupper(static_cast<unsigned char>(letter));
  if (letter == 'h' || letter == 'H') say(Operator::Word::kHold, to_all);
  if (letter == 'r' || letter == 'R') say(Operator::Word::kResume, to_all);
  if (letter == 's' || letter == 'S') say(Operator::Word::kStart, to_all);
  if (letter == '?') help_ = true;
  return letter != 'q';
}

Canvas Dashboard::draw(int columns, int rows) {
  if (help_) return lay_out_help(columns, rows);
  View view = make_view(model_, clock_, chosen_);
  if (clock_.now() - noticed_ < kNoticeShown) view.notice = notice_;
  return lay_out(view, columns, rows);
}

}  // namespace galilean::monitor::top
