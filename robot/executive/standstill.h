// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "robot/executive/event.h"
#include "robot/executive/holding.h"

namespace galilean::robot {

/// The first condition of the current state that holds and that a lock keeps from firing.
struct LockWait {
  std::uint32_t condition = Event::kNone;  ///< of the current state; kNone: none
  Time since{};                            ///< from when on it has held in every tick

  void note(std::uint32_t waiting, Time now) noexcept {
    if (waiting == Event::kNone)
      *this = {};
    else if (waiting != condition)
      *this = {waiting, now};
  }
  bool operator==(const LockWait&) const = default;
};

/// Why a robot stands still, or what it waits for.
struct Standstill {
  Hold hold = Hold::kNone;
  std::uint64_t stopped_at = 0;   ///< of kBreakPoint and kStepEnd: the number of the transition
  std::uint64_t break_point = 0;  ///< of kBreakPoint: its number
  LockWait wait;

  /// But for `hold`.
  void keep(Memory& memory) noexcept {
    memory.keep(stopped_at);
    memory.keep(break_point);
    memory.keep(wait.condition);
    memory.keep(wait.since);
  }
  bool operator==(const Standstill&) const = default;
};

}  // namespace galilean::robot
