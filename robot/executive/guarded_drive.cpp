// SPDX-License-Identifier: BSD-3-Clause
#include "robot/executive/guarded_drive.h"

namespace galilean::robot {

void GuardedDrive::begin(Time now, bool free) noexcept {
  now_ = now;
  free_ = free;
  commanded_ = false;
  orders_ = {};
  // The stop is repeated every tick, because a line that was just restored may have lost the first
  // one.
  if (!free_) stop();
}

void GuardedDrive::drive(const DriveCommand& command) noexcept {
  if (!free_) return;
  motors_.drive(command);
  orders_ = {orders_.count + 1, false, command};
  last_command_ = now_;
  commanded_ = driving_ = true;
}

void GuardedDrive::stop() noexcept {
  motors_.stop();
  orders_ = {orders_.count + 1, true, {}};
  commanded_ = true;
  driving_ = false;
}

void GuardedDrive::finish(bool state_changed) noexcept {
  if (!driving_ || commanded_) return;
  const bool abandoned = state_changed || now_ - last_command_ >= timeout_;
  abandoned ? stop() : motors_.keep_moving();
}

}  // namespace galilean::robot
