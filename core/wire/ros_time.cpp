// SPDX-License-Identifier: BSD-3-Clause
#include "core/wire/ros_time.h"

#include <chrono>

namespace galilean::wire {
namespace {
constexpr std::int64_t kNanosecondsPerSecond = 1'000'000'000;
}

msg::Time ros_time(std::int64_t since_epoch_ns) noexcept {
  msg::Time time;
  time.sec = static_cast<std::int32_t>(since_epoch_ns / kNanosecondsPerSecond);
  time.nanosec = static_cast<std::uint32_t>(since_epoch_ns % kNanosecondsPerSecond);
  return time;
}

std::int64_t since_epoch_ns(const msg::Time& time) noexcept {
  return time.sec * kNanosecondsPerSecond + time.nanosec;
}

std::int64_t wall_clock_ns() noexcept {
  using namespace std::chrono;
  return duration_cast<nanoseconds>(system_clock::now().time_since_epoch()).count();
}

}  // namespace galilean::wire
