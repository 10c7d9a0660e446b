// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/replay/playback.h"

#include <poll.h>

#include <algorithm>
#include <cstdio>

namespace galilean::monitor {
namespace {

constexpr Duration kLongestSleep = std::chrono::milliseconds(500);
constexpr Duration kJump = std::chrono::seconds(10);

}  // namespace

void Playback::every(Duration period, std::function<void()> call) {
  regular_.push_back({period, std::move(call), real_.now()});
}

bool Playback::rest(Time due) {
  while (!termination_.asked()) {
    call_what_is_due();
    const Time now = real_.now();
    if (now >= due) return true;
    sleep(due - now);
  }
  return false;
}

bool Playback::until(Time due, Duration position) {
  while (!termination_.asked()) {
    call_what_is_due();
    for (const auto key : keys_in(keys_.read())) obey(key, due, position);
    if (ended_ || target_) return false;
    const auto left = clock_.real_until(due);
    if (left && *left <= Duration{}) return true;
    sleep(left.value_or(kLongestSleep));
  }
  return false;
}

void Playback::obey(ReplayKey key, Time due, Duration position) {
  switch (key) {
    case ReplayKey::kPause:
      clock_.pause(!clock_.paused());
      break;
    case ReplayKey::kStep:
      clock_.pause(true);
      clock_.move_to(due);
      break;
    case ReplayKey::kFaster:
      clock_.set_rate(std::min(kMostRate, 2 * clock_.rate()));
      break;
    case ReplayKey::kSlower:
      clock_.set_rate(std::max(kLeastRate, clock_.rate() / 2));
      break;
    case ReplayKey::kForward:
      target_ = position + kJump;
      break;
    case ReplayKey::kBack:
      target_ = std::max(Duration{}, position - kJump);
      break;
    case ReplayKey::kBegin:
      target_ = Duration{};
      break;
    case ReplayKey::kEnd:
      ended_ = true;
      break;
  }
  tell(target_.value_or(position));
}

void Playback::tell(Duration position) const {
  std::fprintf(stderr, "%.3f s, %g times as fast%s\n", to_seconds(position), clock_.rate(),
               clock_.paused() ? ", paused" : "");
}

void Playback::call_what_is_due() {
  for (auto& regular : regular_) {
    const Time now = real_.now();
    if (now < regular.next) continue;
    regular.call();
    // A call that was missed is not made up for.
    regular.next = std::max(regular.next + regular.period, now);
  }
}

void Playback::sleep(Duration most) const {
  auto wait = std::min(most, kLongestSleep);
  for (const auto& regular : regular_) wait = std::min(wait, regular.next - real_.now());
  wait = std::max(wait, Duration{});
  const timespec time{wait.count() / 1'000'000'000, wait.count() % 1'000'000'000};
  pollfd events[] = {{termination_.descriptor(), POLLIN, 0}, {keys_.descriptor(), POLLIN, 0}};
  ppoll(events, 2, &time, nullptr);
}

}  // namespace galilean::monitor
