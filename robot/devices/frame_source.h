// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "core/clock.h"
#include "core/device/frame.h"

namespace galilean::robot {

/// Where pictures come from: the simulator's ring, a camera, a file. All calls from one thread.
class FrameSource {
 public:
  virtual ~FrameSource() = default;
  /// True if there was a newer picture, which now stands in `frame.rgb`; else `frame` holds
  /// anything. May wait for a camera's next picture, and tries to open again what was lost.
  virtual bool grab(Frame& frame, Time now) = 0;
  /// One sentence on why no pictures come and what to do; empty while they do.
  [[nodiscard]] virtual std::string problem() const = 0;
};

}  // namespace galilean::robot
