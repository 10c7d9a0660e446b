// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/playback/replay_clock.h"

namespace galilean::monitor {

Time ReplayClock::now() const noexcept {
  if (paused_) return base_;
  const auto passed_ns = static_cast<double>((real_.now() - since_).count()) * rate_;
  return base_ + Duration(static_cast<Duration::rep>(passed_ns));
}

void ReplayClock::begin_anew() noexcept {
  base_ = now();
  since_ = real_.now();
}

void ReplayClock::set_rate(double rate) noexcept {
  begin_anew();
  rate_ = rate;
}

void ReplayClock::pause(bool paused) noexcept {
  begin_anew();
  paused_ = paused;
}

void ReplayClock::move_to(Time time) noexcept {
  begin_anew();
  if (time > base_) base_ = time;
}

void ReplayClock::jump_to(Time time) noexcept {
  begin_anew();
  base_ = time;
}

std::optional<Duration> ReplayClock::real_until(Time time) const noexcept {
  const Duration left = time - now();
  if (left <= Duration{}) return Duration{};
  if (paused_) return std::nullopt;
  return Duration(static_cast<Duration::rep>(static_cast<double>(left.count()) / rate_));
}

}  // namespace galilean::monitor
