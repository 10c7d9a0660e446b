// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/top/sheets/push_sheet.h"

#include <utility>

namespace galilean::monitor::top {

PushSheet::PushSheet(Pusher& pusher, PushWish wish) : pusher_(pusher), wish_(std::move(wish)) {
  pusher_.check(wish_);
}

OpenSheet::Turn PushSheet::press(const Press& press) {
  const auto stage = pusher_.report().stage;
  scroll(direction_of(press));
  if (stage == Stage::kReady && press.letter == 'c' && !wish_.canary.empty())
    with_canary_ = !with_canary_;
  if (stage == Stage::kReady && press.letter == 'y') pusher_.push(with_canary_);
  if (stage == Stage::kPushing && press.letter == 'c') pusher_.cancel();
  if (press.key != Key::kEscape && press.letter != 'n') return stay();
  if (stage != Stage::kPushing) pusher_.cancel();
  return close();
}

Sheet PushSheet::sheet() {
  const PushReport report = pusher_.report();
  return {.title = report.title, .lines = report.lines, .keys = keys_at(report.stage)};
}

std::string PushSheet::keys_at(Stage stage) const {
  if (stage == Stage::kPushing) return "c cancel   Esc look at the team, it goes on";
  if (stage != Stage::kReady) return "Esc back";
  std::string keys =
      "Push to " + (wish_.robots.empty() ? "all robots" : wish_.robots[0]) + "?  y yes   Esc no";
  if (!wish_.canary.empty())
    keys += with_canary_ ? "   c without the canary " + wish_.canary
                         : "   c " + wish_.canary + " runs it first";
  return keys;
}

}  // namespace galilean::monitor::top
