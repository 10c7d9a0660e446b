// SPDX-License-Identifier: BSD-3-Clause
// How an executive is held after a fault.
#include "core/device/frame_grabber.h"
#include "robot/executive/executive.h"

namespace galilean::robot {

/// Goes by the devices of the tick before, so that a robot is held before the tick in which a
/// device is back. What it decides is among the orders of this tick, and a rerun finds it there.
void Executive::watch_faults(Duration since_last_tick) noexcept {
  const FaultCause noted = noted_fault_.exchange(FaultCause::kNone, std::memory_order_relaxed);
  if (noted != FaultCause::kNone) {
    faults_.note(noted);
    // Whoever noted it may not have come to hold the robot yet. Without a hold, the watch would
    // forget the cause in this very tick.
    static_cast<void>(holding_.stop(Hold::kFault));
  }
  if (!setup_.holds_after_faults) return;
  const ControllerStatus& board = port_.status();
  const auto verdict = faults_.judge({.now = tick_.now,
                                      .since_last_tick = since_last_tick,
                                      .tick_period = tick_.period,
                                      .health = health_,
                                      .uses_camera = program() && program()->devices.uses_camera,
                                      .board_heard = board.received,
                                      .camera_heard = devices_.frame_grabber.frame().captured,
                                      .epoch = board.epoch,
                                      .bumpers = board.bumpers,
                                      .hold = holding_.now()});
  if (verdict == FaultWatch::Verdict::kHold) static_cast<void>(holding_.stop(Hold::kFault));
  if (verdict == FaultWatch::Verdict::kLetGo) static_cast<void>(holding_.end_fault());
}

}  // namespace galilean::robot
