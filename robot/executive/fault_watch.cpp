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
  // A slow loop does not stand still: a tick of it may be due only after kShortest.
  if (inputs.since_last_tick > std::max(kShortest, 2 * inputs.tick_period)) {
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
  if (!began_) begin_fault(missing, inputs);
  missing_ = missing;  // the device that is still gone names the fault
  const Duration lasted = lasted_before_ + (inputs.now - *began_);
  if (lasted <= kShortest) return Verdict::kNothing;
  report_ = {missing_, lasted, false};
  return Verdict::kHold;
}

void FaultWatch::begin_fault(FaultCause missing, const Inputs& inputs) noexcept {
  const Time began = missing == FaultCause::kSerialLine ? last_heard(inputs.board_heard, last_well_)
                     : missing == FaultCause::kCamera ? last_heard(inputs.camera_heard, last_well_)
                                                      : last_well_;
  const bool goes_on = missing == missing_ && began - ended_ < kShortest;
  if (!goes_on) lasted_before_ = {};
  // No time counts twice: the device may have been heard last before its fault was found to be
  // over.
  began_ = goes_on ? std::max(began, ended_) : began;
}

void FaultWatch::end_fault(const Inputs& inputs) noexcept {
  if (began_) {
    lasted_before_ += inputs.now - *began_;
    ended_ = inputs.now;
  }
  if (began_ && report_.cause == missing_ && !report_.over) {
    report_.over = true;
    report_.lasted = lasted_before_;
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
    if (report_.cause != FaultCause::kNone) forget();
    return Verdict::kNothing;
  }
  return pushed && ends_at_a_bumper(report_.cause) ? Verdict::kLetGo : Verdict::kNothing;
}

/// Somebody let the robot go on. What was before that holds it no more.
void FaultWatch::forget() noexcept {
  report_ = {};
  missing_ = FaultCause::kNone;
}

}  // namespace galilean::robot
