#pragma once

#include <functional>
#include <thread>

#include "core/clock.h"

namespace galilean::robot {

/// The I/O side of one device of a live robot: calls its `pump` over and over in a thread of its
/// own, with a pause between. Ends with its destructor.
class PumpThread {
 public:
  PumpThread(const Clock& clock, Duration pause, std::function<void(Time)> pump);

 private:
  std::jthread thread_;
};

}  // namespace galilean::robot
