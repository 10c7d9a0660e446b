// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <string>

#include "core/clock.h"
#include "core/worker.h"

namespace galilean::robot {

/// The I/O side of one device of a live robot: calls its `pump` over and over in a thread of its
/// own, with a pause between. Ends with its destructor.
class PumpThread {
 public:
  /// `fail` tells the device that `pump` threw, and why. The pump is tried again all the same.
  PumpThread(const Clock& clock, Duration pause, std::function<void(Time)> pump,
             std::function<void(const std::string& why)> fail);

 private:
  Worker worker_;
};

}  // namespace galilean::robot
