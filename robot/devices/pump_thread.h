// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <string>

#include "core/clock.h"
#include "core/worker.h"

namespace galilean::robot {

/// The I/O side of one device of a live robot. It calls `pump` again and again in a thread of its
/// own, with a pause between. The destructor ends the thread.
class PumpThread {
 public:
  /// `fail` is called with the reason when `pump` threw. The pump is then tried again.
  PumpThread(const Clock& clock, Duration pause, std::function<void(Time)> pump,
             std::function<void(const std::string& why)> fail);

 private:
  Worker worker_;
};

}  // namespace galilean::robot
