// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/top/sheets/history_sheet.h"

#include <algorithm>
#include <ctime>
#include <utility>

#include "core/cut_text.h"
#include "core/wire/ros_time.h"
#include "monitor/top/model/alarms.h"
#include "monitor/top/screen/utf8.h"
#include "monitor/top/sheets/push_sheet.h"

namespace galilean::monitor::top {
namespace {

/// Returns "3 min ago", or the day if that is longer ago than a day.
std::string when_pushed(std::int64_t pushed_ns) {
  constexpr double kDay_s = 24 * 3600;
  const double age_s = static_cast<double>(wire::wall_clock_ns() - pushed_ns) * 1e-9;
  if (age_s < kDay_s) return lasting(age_s) + " ago";
  const std::time_t seconds = pushed_ns / 1'000'000'000;
  std::tm local{};
  localtime_r(&seconds, &local);
  char text[32];
  return {text, std::strftime(text, sizeof text, "%Y-%m-%d", &local)};
}

std::string list_of(const std::vector<std::string>& words, const char* if_none) {
  std::string text;
  for (const auto& word : words) text += (text.empty() ? "" : ", ") + word;
  return text.empty() ? if_none : text;
}

std::string whom_and_answers(const PastPush& push) {
  return list_of(push.targets, "the team") + ": " + list_of(push.outcomes, "no answer");
}

Sheet::Line line_of_push(const PastPush& push, const std::string& runs_hash) {
  constexpr int kWhen = 12, kHash = 10, kProgram = 18, kAuthor = 12, kState = 10;
  const bool runs = !push.hash.empty() && push.hash == runs_hash;
  return {in_column(when_pushed(push.pushed_ns), kWhen) + in_column(cut_text(push.hash, 8), kHash) +
              in_column(push.program, kProgram) + in_column(push.author, kAuthor) +
              in_column(runs ? "runs now" : push.state, kState) + "to " + whom_and_answers(push),
          push.has_failed ? Style::kAlarm
          : runs          ? Style::kGood
                          : Style::kPlain};
}

}  // namespace

HistorySheet::HistorySheet(Pusher& pusher, PushWish wish)
    : pusher_(pusher), wish_(std::move(wish)) {
  pusher_.list();
}

OpenSheet::Turn HistorySheet::press(const Press& press) {
  if (press.key == Key::kEscape) return close();
  const auto pushes = pusher_.pushes().pushes;
  const int last = std::max(static_cast<int>(pushes.size()) - 1, 0);
  chosen_ = static_cast<std::size_t>(
      std::clamp(static_cast<int>(chosen_) + direction_of(press), 0, last));
  if (press.key != Key::kEnter || chosen_ >= pushes.size() || pushes[chosen_].hash.empty())
    return stay();
  if (pusher_.report().stage == PushReport::Stage::kPushing)
    return turn_to(std::make_unique<PushSheet>(pusher_));
  wish_.hash = pushes[chosen_].hash;
  return turn_to(std::make_unique<PushSheet>(pusher_, std::move(wish_)));
}

Sheet HistorySheet::sheet() {
  const auto known = pusher_.pushes();
  const std::string whom = wish_.robots.empty() ? "all robots" : wish_.robots[0];
  Sheet sheet{.title = "What was pushed", .lines = {}, .keys = "Esc back"};
  for (const auto& push : known.pushes) sheet.lines.push_back(line_of_push(push, wish_.runs_hash));
  if (!sheet.lines.empty()) {
    sheet.chosen = std::min(chosen_, known.pushes.size() - 1);
    const PastPush& push = known.pushes[*sheet.chosen];
    sheet.title = "Pushed by " + push.author + " to " + whom_and_answers(push);
    sheet.keys = "Enter differences, and push to " + whom + " after a yes   Esc back";
  } else if (!known.trouble.empty()) {
    sheet.lines = {{known.trouble, Style::kAlarm}};
  } else {
    sheet.lines = {{known.is_known ? "No program was pushed through this monitor yet."
                                   : "The monitor is asked."}};
  }
  return sheet;
}

}  // namespace galilean::monitor::top
