// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <chrono>

namespace galilean {

using Duration = std::chrono::nanoseconds;

/// The tag of the time line that a process uses. Its zero is the moment when the clock was made.
struct ProcessTime {};
using Time = std::chrono::time_point<ProcessTime, Duration>;

[[nodiscard]] constexpr double to_seconds(Duration duration) noexcept {
  return std::chrono::duration<double>(duration).count();
}
[[nodiscard]] constexpr Duration from_seconds(double seconds) noexcept {
  return std::chrono::duration_cast<Duration>(std::chrono::duration<double>(seconds));
}

/// The only source of time in Galilean's logic.
class Clock {
 public:
  virtual ~Clock() = default;
  [[nodiscard]] virtual Time now() const noexcept = 0;
};

/// Runs with the machine's monotonic clock.
class SteadyClock final : public Clock {
 public:
  [[nodiscard]] Time now() const noexcept override {
    return Time{std::chrono::steady_clock::now() - start_};
  }

 private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

/// A clock that moves only when `advance` is called. Tests and the headless simulator use it. Any
/// thread may read it.
class SteppedClock final : public Clock {
 public:
  [[nodiscard]] Time now() const noexcept override { return Time{Duration{elapsed_ns_.load()}}; }
  void advance(Duration step) noexcept { elapsed_ns_ += step.count(); }

 private:
  std::atomic<Duration::rep> elapsed_ns_{0};
};

}  // namespace galilean
