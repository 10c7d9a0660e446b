// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <thread>

#include "core/clock.h"
#include "core/wake.h"

namespace galilean::robot {

/// Calls a tick at a fixed rate from a thread of its own, until this object is destroyed. Deadlines
/// are absolute, so that the rate does not drift. Missed deadlines are left out and not made up
/// for. When `wake` is rung, the loop ticks at once; the deadlines stay where they are. It asks for
/// real-time scheduling, and goes on without it where it is not granted.
class ControlLoop {
 public:
  ControlLoop(Duration period, Wake& wake, std::function<void()> tick);

 private:
  std::jthread thread_;
};

}  // namespace galilean::robot
