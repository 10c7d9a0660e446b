#pragma once

#include <atomic>
#include <functional>
#include <thread>

#include "core/clock.h"

namespace galilean::robot {

/// Calls a tick at a fixed rate from a thread of its own, until destroyed. Deadlines are absolute,
/// so that the rate does not drift; those that were missed are left out, not made up for. Asks for
/// real-time scheduling and does without where it is not granted.
class ControlLoop {
 public:
  ControlLoop(Duration period, std::function<void()> tick);

 private:
  std::jthread thread_;
};

}  // namespace galilean::robot
