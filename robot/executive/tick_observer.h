// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "core/device/comm_port.h"
#include "core/schema/schema.h"
#include "robot/executive/event.h"
#include "robot/executive/fault_watch.h"
#include "robot/executive/guarded_drive.h"
#include "robot/executive/holding.h"
#include "robot/executive/running_program.h"
#include "robot/executive/standstill.h"

namespace galilean {
struct Devices;
}

namespace galilean::robot {

class Executive;

/// What an executive shows of a tick at its end.
struct TickView {
  const Tick& tick;
  const RunningProgram* program;  ///< null while there is none
  const Devices& devices;
  DeviceHealth health;
  Pose2 pose;                  ///< by dead reckoning, odom frame
  double speed_mps = 0;        ///< forward positive, as the wheels turned last
  double turn_rate_radps = 0;  ///< counter-clockwise positive
  Standstill standstill = {};
  FaultReport fault = {};  ///< for which the robot is held; its cause is kNone if for none
  bool out_of_service = false;
  bool in_probation = false;
  Duration tick_time{};           ///< time from exchange to act
  std::uint32_t overruns = 0;     ///< ticks that began late by a whole period, since the start
  std::uint64_t transitions = 0;  ///< since the start
  StandingOrders orders = {};
  std::uint64_t break_table = 0;  ///< the number of the table of break points that it went by
  MotionOrders motion = {};
  std::optional<GripperCommand> gripper = {};  ///< what it was ordered in this tick
  const Executive* executive = nullptr;        ///< the one that is shown
};

/// Watches an executive from within its control loop. Requires: neither method allocates, waits or
/// does I/O. The arguments are valid during the call only.
class TickObserver {
 public:
  virtual ~TickObserver() = default;
  /// Is called when the event happens, before the end of its tick.
  virtual void on_event(const Event& event) noexcept = 0;
  virtual void on_tick(const TickView& view) noexcept = 0;
};

}  // namespace galilean::robot
