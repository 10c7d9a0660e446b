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
  const bool abandoned = state_changed || now_ - last_command_ >= timeout_;
  if (driving_ && !commanded_ && abandoned) stop();
}

}  // namespace galilean::robot
