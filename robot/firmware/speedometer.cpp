// SPDX-License-Identifier: BSD-3-Clause
#include "robot/firmware/speedometer.h"

namespace galilean::robot::firmware {
namespace {

constexpr float kMillisecondsASecond = 1000;

float travelled(std::int32_t from_counts, std::int32_t to_counts) {
  const auto counts =
      static_cast<std::uint32_t>(to_counts) - static_cast<std::uint32_t>(from_counts);
  return static_cast<float>(static_cast<std::int32_t>(counts));
}

}  // namespace

void Speedometer::reset(std::int32_t counts, std::uint32_t now_ms) {
  newest_ = {counts, now_ms};
  samples_.fill(newest_);
  begin_ms_ = now_ms;
  speed_ = change_ = 0;
}

void Speedometer::sample(std::int32_t counts, std::uint32_t now_ms) {
  const Sample begin = samples_[oldest_];
  // Dividing by the mean period gives even periods the same speed to the last bit, whatever their
  // sum rounds to.
  const float period_s =
      static_cast<float>(now_ms - begin.time_ms) / kSamples / kMillisecondsASecond;
  const float speed = travelled(begin.counts, counts) / (kSamples * period_s);
  // The speed is that at the window's middle. A sample moves the middle by half of the newest
  // period and half of the period that leaves the window.
  const std::uint32_t moved_twice_ms = (now_ms - newest_.time_ms) + (begin.time_ms - begin_ms_);
  change_ = (speed - speed_) / (static_cast<float>(moved_twice_ms) / (2 * kMillisecondsASecond));
  speed_ = speed;
  begin_ms_ = begin.time_ms;
  newest_ = samples_[oldest_] = {counts, now_ms};
  oldest_ = (oldest_ + 1) % kSamples;
}

float Speedometer::recent_speed_counts_s() const {
  Sample begin = newest_;
  for (std::size_t back = 2; back <= kSamples; ++back) {
    begin = samples_[(oldest_ + kSamples - back) % kSamples];
    if (newest_.time_ms - begin.time_ms >= kRecent_ms) break;
  }
  const std::uint32_t span_ms = newest_.time_ms - begin.time_ms;
  if (span_ms == 0) return 0;
  return travelled(begin.counts, newest_.counts) * kMillisecondsASecond /
         static_cast<float>(span_ms);
}

}  // namespace galilean::robot::firmware
