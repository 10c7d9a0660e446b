// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "monitor/top/model/dashboard_model.h"
#include "monitor/top/sheets/open_sheet.h"
#include "monitor/top/steering/steering.h"

namespace galilean::monitor::top {

/// Lists a robot's break points and locks, and changes them.
class BreakSheet : public OpenSheet {
 public:
  /// Chooses the lock at which the robot waits, if it does. `over_past` says that an instant of the
  /// past is shown below; the sheet is of the present. Requires: the references outlive this.
  BreakSheet(const DashboardModel& model, Steering& steering, std::string robot, bool over_past);

  [[nodiscard]] Turn press(const Press& press) override;

 protected:
  [[nodiscard]] Sheet sheet() override;

 private:
  /// Returns what the robot told; nullptr if it told nothing.
  [[nodiscard]] const msg::Breaks* breaks() const;
  /// Returns the chosen point; nullptr if there is none, or if somebody has taken it off meanwhile.
  [[nodiscard]] const msg::BreakPoint* chosen() const;
  /// Chooses the point in that line, or the last one. Requires: the robot told of points.
  void choose(std::size_t line);
  void press_letter(char letter);
  void change(const msg::BreakPoint& point, char letter);

  const DashboardModel& model_;
  Steering& steering_;
  const std::string robot_;
  const bool over_past_;
  std::size_t line_ = 0;
  /// By its two states: another operator's order may move the lines between a look and a key.
  msg::BreakPoint chosen_;
};

}  // namespace galilean::monitor::top
