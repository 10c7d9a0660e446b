// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "monitor/top/gains/reach.h"
#include "monitor/top/gains/tuner.h"
#include "monitor/top/model/dashboard_model.h"
#include "monitor/top/push/pusher.h"
#include "monitor/top/sheets/open_sheet.h"

namespace galilean::monitor::top {

/// Moves the gains and thresholds of the running program. What was moved goes the way of every
/// push: the monitor checks it, and robots go back from it if it fails within its probation.
class GainSheet : public OpenSheet {
 public:
  /// `robot` is the robot whose numbers are moved; empty: the team's. Requires: the references
  /// outlive this.
  GainSheet(const DashboardModel& model, Pusher& pusher, std::string robot);

  [[nodiscard]] Turn press(const Press& press) override;

 protected:
  [[nodiscard]] Sheet sheet() override;

 private:
  /// Takes over what runs now. Returns whom a change would reach.
  Reach look();
  void press_with_numbers(const Press& press);
  /// Returns why nothing can be sent now; empty: something can.
  [[nodiscard]] std::string hindrance() const;
  void send();
  void undo();
  /// Returns the state of what was sent, or why nothing was; empty: nothing is to be told.
  [[nodiscard]] std::string told() const;

  const DashboardModel& model_;
  Pusher& pusher_;
  const std::string robot_;
  Tuner tuner_;
  std::size_t chosen_ = 0;
  bool has_sent_ = false;  ///< the push that is reported is of this sheet
  std::string objection_;  ///< why the last key changed nothing
};

}  // namespace galilean::monitor::top
