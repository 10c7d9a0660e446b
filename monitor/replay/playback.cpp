// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/replay/playback.h"

#include <poll.h>

#include <algorithm>
#include <cstdio>

namespace galilean::monitor {
namespace {

constexpr Duration kLookEach = std::chrono::milliseconds(500);
constexpr Duration kJump = std::chrono::seconds(10);

}  // namespace

bool Playback::rest(Time due, const Look& look) {
  while (!termination_.asked()) {
    look_now_and_then(look);
    const Time now = real_.now();
    if (now >= due) return true;
    sleep(due - now);
  }
  return false;
}

bool Playback::until(Time due, Duration position, const Look& look) {
  while (!termination_.asked()) {
    look_now_and_then(look);
    for (const auto key : keys_in(keys_.read())) obey(key, due, position);
    if (ended_ || target_) return false;
    const auto left = clock_.real_until(due);
    if (left && *left <= Duration{}) return true;
    sleep(left.value_or(kLookEach));
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

void Playback::look_now_and_then(const Look& look) {
  if (!look || real_.now() < next_look_) return;
  look();
  next_look_ = real_.now() + kLookEach;
}

void Playback::sleep(Duration most) const {
  const auto wait = std::min(most, kLookEach);
  const timespec time{wait.count() / 1'000'000'000, wait.count() % 1'000'000'000};
  pollfd events[] = {{termination_.descriptor(), POLLIN, 0}, {keys_.descriptor(), POLLIN, 0}};
  ppoll(events, 2, &time, nullptr);
}

}  // namespace galilean::monitor
