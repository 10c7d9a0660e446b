// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <optional>
#include <utility>
#include <vector>

#include "core/key_terminal.h"
#include "core/termination.h"
#include "monitor/playback/replay_clock.h"
#include "monitor/replay/replay_keys.h"

namespace galilean::monitor {

/// Waits for the times of a replay, and lets people pause it, step, change its rate and go to
/// another place by keys. For use by one thread.
class Playback {
 public:
  static constexpr double kLeastRate = 0.01, kMostRate = 100;

  /// Requires: `real` and `termination` outlive this.
  Playback(const Clock& real, Termination& termination, double rate)
      : real_(real), termination_(termination), clock_(real, rate) {}

  /// Returns the replay's time, by which messages are due.
  [[nodiscard]] const Clock& clock() const noexcept { return clock_; }
  [[nodiscard]] bool has_keys() const noexcept { return keys_.is_there(); }

  /// Calls `call` each `period` of real time while it waits, also while the replay is paused.
  /// Requires: `period` is above 0.
  void every(Duration period, std::function<void()> call);

  /// Waits until `due` by the real clock. Returns false if the replay has to end.
  [[nodiscard]] bool rest(Time due);
  /// Waits until `due` by the replay's clock. `position` is where it is in the recording. Returns
  /// false if the replay has to end, or to go on at another place: see `take_target`.
  [[nodiscard]] bool until(Time due, Duration position);
  /// Returns where in the recording the replay has to go on; nothing if it has to end.
  [[nodiscard]] std::optional<Duration> take_target() noexcept {
    return std::exchange(target_, std::nullopt);
  }

 private:
  struct Regular {
    Duration period;
    std::function<void()> call;
    Time next;
  };

  void obey(ReplayKey key, Time due, Duration position);
  void tell(Duration position) const;
  void call_what_is_due();
  void sleep(Duration most) const;

  const Clock& real_;
  Termination& termination_;
  ReplayClock clock_;
  KeyTerminal keys_;
  std::optional<Duration> target_;
  bool ended_ = false;
  std::vector<Regular> regular_;
};

}  // namespace galilean::monitor
