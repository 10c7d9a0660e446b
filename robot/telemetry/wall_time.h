// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/clock.h"
#include "core/wire/messages.h"
#include "core/wire/ros_time.h"

namespace galilean::robot {

/// Converts the process's own time to wall-clock time, which messages are stamped with. `refresh`
/// measures the difference anew, because a wall clock may be set.
class WallTime {
 public:
  explicit WallTime(const Clock& clock) : clock_(clock) { refresh(); }

  void refresh() noexcept {
    epoch_ns_ = wire::wall_clock_ns() - clock_.now().time_since_epoch().count();
  }
  [[nodiscard]] msg::Time stamp(Time time) const noexcept {
    return wire::ros_time(epoch_ns_ + time.time_since_epoch().count());
  }
  [[nodiscard]] static msg::Time now() noexcept { return wire::ros_time(wire::wall_clock_ns()); }

 private:
  const Clock& clock_;
  std::int64_t epoch_ns_ = 0;
};

}  // namespace galilean::robot
