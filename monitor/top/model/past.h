// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "monitor/top/model/dashboard_model.h"
#include "monitor/top/model/history.h"

namespace galilean::monitor::top {

/// What was known at an instant. Its clock stands still.
class Past {
 public:
  Past(const History& history, Time instant);

  [[nodiscard]] const DashboardModel& model() const noexcept { return model_; }
  [[nodiscard]] const Clock& clock() const noexcept { return clock_; }

 private:
  SteppedClock clock_;
  DashboardModel model_{clock_};
};

}  // namespace galilean::monitor::top
