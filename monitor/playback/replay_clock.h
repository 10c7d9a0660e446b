// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "core/clock.h"

namespace galilean::monitor {

/// The time of a replay: it runs faster or slower than a real clock, and may stand still. For use
/// by one thread.
class ReplayClock final : public Clock {
 public:
  /// Requires: `real` outlives this, and `rate` is above 0.
  ReplayClock(const Clock& real, double rate) : real_(real), rate_(rate), since_(real.now()) {}

  [[nodiscard]] Time now() const noexcept override;
  [[nodiscard]] double rate() const noexcept { return rate_; }
  [[nodiscard]] bool paused() const noexcept { return paused_; }
  /// Requires: `rate` is above 0.
  void set_rate(double rate) noexcept;
  void pause(bool paused) noexcept;
  /// Moves it on to that time, if it is not there yet.
  void move_to(Time time) noexcept;
  /// Moves it to that time, also back.
  void jump_to(Time time) noexcept;
  /// Returns how long that is by the real clock; nothing if it stands still until then.
  [[nodiscard]] std::optional<Duration> real_until(Time time) const noexcept;

 private:
  void begin_anew() noexcept;

  const Clock& real_;
  double rate_;
  bool paused_ = false;
  Time base_{}, since_;  ///< its time at that real time
};

}  // namespace galilean::monitor
