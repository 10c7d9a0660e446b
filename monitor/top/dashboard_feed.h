// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/wake.h"
#include "monitor/ingest/ingest.h"
#include "monitor/top/model/dashboard_model.h"
#include "monitor/top/model/history.h"

namespace galilean::monitor::top {

/// Reads the domain's messages into a DashboardModel.
class DashboardFeed {
 public:
  DashboardFeed(wire::Participant& participant, const Clock& clock)
      : model_(clock),
        history_(clock),
        ingest_(
            participant,
            {.message =
                 [this](const Message& message) {
                   model_.receive(message);
                   history_.note(message);
                 }},
            [this] { wake_.ring(); },
            [](const Channel& channel) {
              return DashboardModel::shows(channel.schema->ros_type);
            }) {}

  [[nodiscard]] const DashboardModel& model() const noexcept { return model_; }
  [[nodiscard]] const History& history() const noexcept { return history_; }
  [[nodiscard]] int descriptor() const noexcept { return wake_.descriptor(); }
  void poll() {
    wake_.clear();
    ingest_.poll();
  }

 private:
  Wake wake_;
  DashboardModel model_;
  History history_;
  Ingest ingest_;
};

}  // namespace galilean::monitor::top
