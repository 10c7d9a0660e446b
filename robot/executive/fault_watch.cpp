// SPDX-License-Identifier: BSD-3-Clause
#include "robot/executive/fault_watch.h"

#include <algorithm>

namespace galilean::robot {
namespace {

/// Returns when a device was last well: when it was last heard, if that is known and was before the
/// last tick in which it counted as well. It goes on counting as well for its timeout.
Time last_heard(Time heard, Time last_well) noexcept {
  return heard == Time{} ? last_well : std::min(heard, last_well);
}

}  // namespace

FaultWatch::Verdict FaultWatch::judge(const Inputs& inputs) noexcept {
  answered_.comm_port |= inputs.health.comm_port;
  answered_.motor_drive |= inputs.health.motor_drive;
  answered_.frame_grabber |= inputs.health.frame_grabber;
  const FaultCause missing = missing_device(inputs);
  if (missing != FaultCause::kNone) return judge_missing(missing, inputs);
  end_fault(inputs);
  if (inputs.since_last_tick > kShortest) {
    pressed_ = true;
    report_ = {FaultCause::kStall, inputs.since_last_tick, true};
    return Verdict::kHold;
  }
  return judge_well(inputs);
}

void FaultWatch::note(FaultCause cause) noexcept {
  report_ = {cause, {}, true};
  pressed_ = true;
}

FaultCause FaultWatch::missing_device(const Inputs& inputs) const noexcept {
  const DeviceHealth& health = inputs.health;
  if (answered_.comm_port && !health.comm_port) return FaultCause::kSerialLine;
  if (answered_.motor_drive && !health.motor_drive) return FaultCause::kMotorDrive;
  if (inputs.uses_camera && answered_.frame_grabber && !health.frame_grabber)
    return FaultCause::kCamera;
  return FaultCause::kNone;
}

/// Holds the robot while the fault goes on, so that it cannot move in the tick in which a device is
/// back. Whoever resumes it meanwhile does not let it move later: it is held again.
FaultWatch::Verdict FaultWatch::judge_missing(FaultCause missing, const Inputs& inputs) noexcept {
  pressed_ = true;
  if (!began_) {
    missing_ = missing;
    began_ = missing == FaultCause::kSerialLine ? last_heard(inputs.board_heard, last_well_)
             : missing == FaultCause::kCamera   ? last_heard(inputs.camera_heard, last_well_)
                                                : last_well_;
  }
  const Duration lasted = inputs.now - *began_;
  if (lasted <= kShortest) return Verdict::kNothing;
  report_ = {missing_, lasted, false};
  return Verdict::kHold;
}

void FaultWatch::end_fault(const Inputs& inputs) noexcept {
  if (began_ && report_.cause == missing_ && !report_.over) {
    report_.over = true;
    report_.lasted = inputs.now - *began_;
    if (missing_ == FaultCause::kSerialLine && inputs.epoch != last_epoch_)
      report_.cause = FaultCause::kBoard;
  }
  began_.reset();
  last_well_ = inputs.now;
  last_epoch_ = inputs.epoch;
}

FaultWatch::Verdict FaultWatch::judge_well(const Inputs& inputs) noexcept {
  const bool is_known = inputs.health.comm_port;
  const bool pushed = is_known && inputs.bumpers != 0 && !pressed_;
  pressed_ = !is_known || inputs.bumpers != 0;
  if (inputs.hold != Hold::kFault) {
    report_ = {};
    return Verdict::kNothing;
  }
  return pushed ? Verdict::kLetGo : Verdict::kNothing;
}

}  // namespace galilean::robot
