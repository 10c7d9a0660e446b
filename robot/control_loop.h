// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <thread>

#include "core/clock.h"
#include "core/wake.h"

namespace galilean::robot {

/// Calls a tick at a fixed rate from a thread of its own, until destroyed. Deadlines are absolute,
/// so that the rate does not drift; those that were missed are left out, not made up for. When
/// `wake` is rung it ticks at once, between two deadlines that stay where they are. Asks for
/// real-time scheduling and does without where it is not granted.
class ControlLoop {
 public:
  ControlLoop(Duration period, Wake& wake, std::function<void()> tick);

 private:
  std::jthread thread_;
};

}  // namespace galilean::robot
