// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "core/clock.h"

namespace galilean {

/// Common to all devices. `sense` and what schemas call belong to the control loop: they neither
/// block nor allocate. Bytes and frames move in another thread, or between ticks.
class Device {
 public:
  virtual ~Device() = default;
  /// Start of a tick: takes over the newest that arrived.
  virtual void sense(Time now) noexcept = 0;
  /// False while it is missing or silent for longer than its timeout.
  [[nodiscard]] virtual bool healthy() const noexcept = 0;
  /// One sentence on what is missing and what to do; empty when well. Any thread but the control
  /// loop.
  [[nodiscard]] virtual std::string problem() const = 0;
};

}  // namespace galilean
