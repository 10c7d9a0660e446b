// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "core/clock.h"

namespace galilean {

/// What all devices have in common. `sense`, and the functions that schemas call, run in the
/// control loop: they neither block nor allocate. Bytes and frames are moved by another thread, or
/// between ticks.
class Device {
 public:
  virtual ~Device() = default;
  /// Takes over the newest data that arrived. It is called at the start of each tick.
  virtual void sense(Time now) noexcept = 0;
  /// Returns false while the device is missing or has been silent for longer than its timeout.
  [[nodiscard]] virtual bool healthy() const noexcept = 0;
  /// Returns one sentence on what is missing and what to do, or an empty text when the device is
  /// well. Requires: the caller is not the control loop.
  [[nodiscard]] virtual std::string problem() const = 0;
};

}  // namespace galilean
