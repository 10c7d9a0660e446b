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
  /// Takes a newer picture into `frame.rgb`, if there is one. Returns whether there was. Otherwise
  /// the content of `frame` is undefined. It may wait for a camera's next picture. It tries to open
  /// a lost source again.
  virtual bool grab(Frame& frame, Time now) = 0;
  /// Returns one sentence on why no pictures come and what to do, or an empty text while they come.
  [[nodiscard]] virtual std::string problem() const = 0;
};

}  // namespace galilean::robot
