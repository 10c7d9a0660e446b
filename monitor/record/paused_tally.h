// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

#include "core/wire/sequence_tally.h"

namespace galilean::monitor {

/// Tells how many of a writer's messages nobody misses, because the recording was paused: those
/// that came, and those that were lost between two that came in the same pause. What was lost at
/// the edge of a pause may have been sent beside it, and stays lost.
class PausedTally {
 public:
  /// Takes note of a message that came in a pause. `pause` numbers the pauses, from 1. Requires:
  /// `tally` has taken note of the message.
  void note(std::uint64_t pause, const wire::SequenceTally& tally) noexcept {
    ++came_;
    if (pause == pause_) lost_ += tally.lost() - lost_then_;
    pause_ = pause;
    lost_then_ = tally.lost();
  }

  [[nodiscard]] std::uint64_t came() const noexcept { return came_; }
  [[nodiscard]] std::uint64_t lost() const noexcept { return lost_; }

 private:
  std::uint64_t came_ = 0, lost_ = 0;
  std::uint64_t pause_ = 0;      ///< in which the newest came; 0: none has come in a pause
  std::uint64_t lost_then_ = 0;  ///< what the writer's tally had lost when it came
};

}  // namespace galilean::monitor
