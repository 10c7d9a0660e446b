// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "core/clock.h"
#include "core/device/frame.h"

namespace galilean::robot {

/// A source of pictures: the simulator's ring, a camera or a file. Requires: all calls come from
/// one thread.
class FrameSource {
 public:
  virtual ~FrameSource() = default;
  /// True if there was a newer picture, which now stands in `frame.rgb`; else `frame` holds
  /// anything. May wait for a camera's next picture, and tries to open again what was lost.
  virtual bool grab(Frame& frame, Time now) = 0;
  /// Returns one sentence on why no pictures come and what to do, or an empty text while they come.
  [[nodiscard]] virtual std::string problem() const = 0;
};

}  // namespace galilean::robot
