// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/clock.h"

namespace galilean::robot {

/// The times at which the ticks of a control loop are due. Deadlines are whole periods after the
/// first, so that the rate does not drift, however long a tick takes. Of the deadlines that passed
/// during a tick only the last remains: the loop ticks at once, and does not make up for the
/// others.
class Pacing {
 public:
  /// The first tick is due at `first`. Requires: `period` is above 0.
  Pacing(Time first, Duration period) noexcept : deadline_(first), period_(period) {}

  /// Returns when the next tick is due.
  [[nodiscard]] Time deadline() const noexcept { return deadline_; }
  /// Moves the deadline on, because the tick that was due is over.
  void advance(Time now) noexcept {
    deadline_ += period_;
    if (now > deadline_) deadline_ += (now - deadline_) / period_ * period_;
  }

 private:
  Time deadline_;
  Duration period_;
};

}  // namespace galilean::robot
