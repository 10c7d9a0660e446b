// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>

#include "core/clock.h"
#include "core/device/comm_port.h"
#include "core/static_vector.h"
#include "robot/executive/event.h"
#include "robot/executive/guarded_drive.h"
#include "robot/executive/holding.h"
#include "robot/executive/snapshot.h"

namespace galilean::robot {

/// What a tick led to. A digest is of all bits, so that two runs can be compared tick by tick.
struct TickOutcome {
  ProgramId program = 0;  ///< 0: none
  std::uint32_t state = 0;
  std::uint64_t transitions = 0;
  std::uint32_t fired = Event::kNone;  ///< condition of the state that was left
  MotionOrders motion;
  std::optional<GripperCommand> gripper;
  std::uint64_t rest = 0;  ///< of pose, standstill, probation, overruns and failed schemas
  StaticVector<std::uint64_t, Snapshot::kMostVariables> variables;  ///< in the store's order
};

/// All that an executive read from outside in one tick, without the pixels, and what it led to.
struct TickRecord {
  std::uint64_t tick = 0;
  Time now{};
  Duration period{};
  Duration tick_time{};
  StandingOrders orders;
  std::uint64_t break_table = 0;
  ProgramId taken_over = 0;   ///< the loaded program that took over in this tick; 0: none
  ProgramId rolled_back = 0;  ///< the program that an order took off in this tick; 0: none
  ShortText reason;           ///< of that order
  DeviceHealth health;
  ControllerStatus board;
  std::uint64_t frame = 0;
  Time captured{};
  bool has_picture = false;  ///< the frame is another than in the tick before
  TickOutcome outcome;
  std::size_t memory_words = 0;  ///< of the executive's memory; 0: it was not taken in this tick
  bool has_predecessor = false;  ///< with it: there is a program to go back to
};

}  // namespace galilean::robot
