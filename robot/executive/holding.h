// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <cstdint>

namespace galilean::robot {

/// Whether the motors may turn, and who or what keeps them still.
enum class Hold : std::uint8_t {
  kNone,        ///< they may
  kStepping,    ///< they may until the next change of state
  kOperator,    ///< an operator holds the robot
  kBreakPoint,  ///< a break point of the robot stopped it
  kStepEnd,     ///< the end of a step stopped it
  kTeam,        ///< a break point of another robot stopped the team
  kFault,       ///< a fault stopped it, and nobody has let it go on since
};

[[nodiscard]] constexpr bool lets_drive(Hold hold) noexcept {
  return hold == Hold::kNone || hold == Hold::kStepping;
}
/// Returns whether a break point or a step made the robot stand, so that a step may let it go.
[[nodiscard]] constexpr bool is_stop(Hold hold) noexcept {
  return !lets_drive(hold) && hold != Hold::kOperator && hold != Hold::kFault;
}

/// What operators and other robots had ordered, and what faults had caused, when a tick began. The
/// whole tick goes by it, so that the order of what happens in a tick and beside it never matters.
struct StandingOrders {
  Hold hold = Hold::kNone;
  bool hold_changed = false;  ///< by another thread or after a fault, since the tick before
  bool in_service = true;
};

/// What holds a robot now. An operator's hold is stronger than all else: only `resume` ends it. A
/// hold after a fault ends no more easily, but for `end_fault`.
/// Any thread may call it, and no call waits.
class Holding {
 public:
  [[nodiscard]] Hold now() const noexcept { return hold_.load(std::memory_order_relaxed); }

  /// Puts it in place as it was in another run.
  void replay(Hold hold) noexcept { hold_.store(hold, std::memory_order_relaxed); }
  void hold() noexcept { hold_.store(Hold::kOperator, std::memory_order_relaxed); }
  void resume() noexcept { hold_.store(Hold::kNone, std::memory_order_relaxed); }
  /// Lets the robot go on until its next change of state. Returns false, and changes nothing, if an
  /// operator holds it, or a fault does.
  [[nodiscard]] bool step() noexcept {
    return change(Hold::kStepping,
                  [](Hold before) { return lets_drive(before) || is_stop(before); });
  }
  /// Stops the robot for the reason `why`. Returns false, and changes nothing, if it stands
  /// already.
  [[nodiscard]] bool stop(Hold why) noexcept { return change(why, lets_drive); }
  /// Ends a step. Returns false, and changes nothing, if the robot makes none.
  [[nodiscard]] bool end_step() noexcept {
    return change(Hold::kStepEnd, [](Hold before) { return before == Hold::kStepping; });
  }
  /// Ends a hold after a fault. Returns false, and changes nothing, if there is none.
  [[nodiscard]] bool end_fault() noexcept {
    return change(Hold::kNone, [](Hold before) { return before == Hold::kFault; });
  }

 private:
  template <class May>
  bool change(Hold to, May may) noexcept {
    Hold before = now();
    while (may(before))
      if (hold_.compare_exchange_weak(before, to, std::memory_order_relaxed)) return true;
    return false;
  }

  std::atomic<Hold> hold_{Hold::kNone};
};

}  // namespace galilean::robot
