// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <map>
#include <string>

#include "core/wake.h"
#include "monitor/ingest/ingest.h"
#include "monitor/top/model/dashboard_model.h"
#include "monitor/top/model/history.h"

namespace galilean::monitor::top {

/// Reads the domain's messages into a DashboardModel.
class DashboardFeed {
 public:
  DashboardFeed(wire::Participant& participant, const Clock& clock);

  [[nodiscard]] const DashboardModel& model() const noexcept { return model_; }
  [[nodiscard]] const History& history() const noexcept { return history_; }
  [[nodiscard]] int descriptor() const noexcept { return wake_.descriptor(); }
  /// Takes what has come. The variables of robots that are not shown are taken twice a second, as
  /// often as the history keeps them.
  void poll();
  /// Takes each message with this robot's variables. Reads what it sees where no monitor tells of
  /// the team's map, and nobody else's sightings: they come with each camera frame, and of a large
  /// team they are half of all messages.
  void look_through(const std::string& robot);

 private:
  void let_variables_rest();
  /// Tells the model, once a second, what was not taken.
  void note_intake();

  Wake wake_;
  DashboardModel model_;
  History history_;
  const Clock& clock_;
  std::map<std::string, std::uint32_t> sightings_, variables_;  ///< channels by topic
  std::string shown_variables_;                                 ///< the topic of the shown robot
  Time all_due_{}, intake_due_{};
  std::uint32_t looked_through_ = 0;  ///< the channel that is read; 0: none
  Ingest ingest_;
};

}  // namespace galilean::monitor::top
