// SPDX-License-Identifier: BSD-3-Clause
#include "robot/executive/pushable_port.h"

namespace galilean::robot {

void PushablePort::push(int index) noexcept {
  if (index < 0 || index >= ControllerStatus::kBumpers) return;
  asked_.fetch_or(static_cast<std::uint8_t>(1U << index), std::memory_order_relaxed);
}

void PushablePort::sense(Time now) noexcept {
  port_.sense(now);
  gripper_.reset();
  if (now >= release_) pushed_ = 0;
  if (const std::uint8_t asked = asked_.exchange(0, std::memory_order_relaxed)) {
    pushed_ |= asked;
    release_ = now + kPush;
  }
  status_ = port_.status();
  status_.bumpers |= pushed_;
}

}  // namespace galilean::robot
