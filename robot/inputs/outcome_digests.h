// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>

#include "robot/executive/tick_observer.h"
#include "robot/inputs/tick_record.h"

namespace galilean::robot {

/// Makes the outcome of a tick. The control loop calls it: it neither allocates nor waits.
class OutcomeDigests {
 public:
  /// Writes all of `to` but `fired`.
  void take(const TickView& view, TickOutcome& to) noexcept;

 private:
  /// A picture is large, and changes only when a schema writes it.
  struct KnownPicture {
    const void* pixels = nullptr;
    std::uint64_t frame = 0;
    std::uint64_t written_tick = 0;
    std::uint64_t digest = 0;
  };

  [[nodiscard]] std::uint64_t pixels_of(const Variable<Image>& image, std::size_t index) noexcept;

  std::array<KnownPicture, Snapshot::kMostVariables> known_{};  ///< by the variable's index
};

}  // namespace galilean::robot
