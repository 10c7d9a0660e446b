// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "monitor/top/model/dashboard_model.h"
#include "monitor/top/model/view.h"
#include "monitor/top/operator.h"
#include "monitor/top/screen/canvas.h"
#include "monitor/top/screen/keys.h"

namespace galilean::monitor::top {

/// The dashboard's state: the chosen robot, the help page and the last notice. Keys change it and
/// send commands to robots.
class Dashboard {
 public:
  Dashboard(const DashboardModel& model, const Clock& clock, Operator& speaker, std::string chosen)
      : model_(model), clock_(clock), speaker_(speaker), chosen_(std::move(chosen)) {}

  /// Handles a key. Returns false if it was the key to quit.
  [[nodiscard]] bool press(const Press& press);
  [[nodiscard]] Canvas draw(int columns, int rows);

 private:
  void choose(std::size_t number);
  void move(int step);
  void say(Operator::Word word, bool to_all);

  const DashboardModel& model_;
  const Clock& clock_;
  Operator& speaker_;
  std::string chosen_;
  bool help_ = false;
  std::string notice_;
  Time noticed_{};
};

}  // namespace galilean::monitor::top
