// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <mutex>
#include <string>
#include <string_view>

#include "core/clock.h"

namespace galilean::monitor {

/// What goes wrong on the map's thread, for those who tell operators of it. A map that fails,
/// stands still or is given too much concerns nobody else: messages, commands and pushes go past
/// it. Any thread may use it.
class MapWatch {
 public:
  /// A map that has done nothing for so long stands still. An update takes a fraction of it.
  static constexpr Duration kPatience = std::chrono::seconds(3);
  /// What went wrong is a problem for so long. If it goes on, it is one all the time.
  static constexpr Duration kTold = std::chrono::seconds(10);

  explicit MapWatch(const Clock& clock) : clock_(clock), alive_(clock.now()) {}

  /// Notes that the map's thread goes on.
  void note_alive();
  /// Notes that a message or an update failed. Writes to stderr if none had for kTold.
  void note_failure(std::string_view why);
  /// Notes that a message was dropped, because too many wait.
  void note_dropped();

  /// Returns what is wrong, in one sentence; empty: nothing is.
  [[nodiscard]] std::string problem() const;
  [[nodiscard]] std::uint64_t failures() const;
  [[nodiscard]] std::uint64_t dropped() const;

 private:
  /// Something that happens now and then.
  struct Count {
    std::uint64_t times = 0;
    Time newest{};
  };
  /// Returns whether it had not happened for kTold.
  bool note(Count& count) const;
  [[nodiscard]] bool is_lately(const Count& count, Time now) const;

  const Clock& clock_;
  mutable std::mutex mutex_;  ///< of all below
  Time alive_;
  Count failures_, dropped_;
  std::string newest_failure_;
};

}  // namespace galilean::monitor
