// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>

#include "core/wire/messages.h"
#include "core/wire/writer.h"
#include "robot/executive/snapshot.h"
#include "robot/telemetry/break_desk.h"
#include "robot/telemetry/publisher.h"
#include "robot/telemetry/wall_time.h"

namespace galilean::robot {

/// Publishes where the robot stops and why it stands, at each change and every second. When a break
/// point that stops the team is reached, it tells every robot to stop. The publisher's thread calls
/// it.
class BreakPublisher {
 public:
  /// Requires: `desk` outlives this.
  /// Errors: throws std::runtime_error if DDS refuses a topic.
  BreakPublisher(const TelemetrySource& source, const BreakDesk& desk);

  /// Logs that the event stopped the robot, and stops the team if the break point says so.
  void on_event(const Event& event);
  /// Is called in each round with the newest snapshot, after the events before it.
  void on_round(const Snapshot& newest);

 private:
  /// What a message would show, as far as it changes.
  struct Shown {
    std::uint64_t orders = 0;
    Standstill standstill;
    bool operator==(const Shown&) const = default;
  };

  void log_break(const BreakPoint& point, std::uint64_t transition);
  [[nodiscard]] msg::TeamStop team_stop_at(const BreakPoint& point, std::uint64_t transition) const;
  [[nodiscard]] msg::Breaks compose(const Snapshot& newest, const BreakDesk::Told& told);
  void tell_points(msg::Breaks& to) const;
  void tell_stop(const Standstill& standstill, const BreakDesk::Told& told, msg::Breaks& to) const;
  void tell_wait(const Snapshot& newest, msg::Breaks& to) const;

  const std::string robot_;
  Executive& executive_;
  const BreakDesk& desk_;
  const Clock& clock_;
  WallTime wall_;
  wire::Writer<msg::Breaks> breaks_;
  wire::Writer<msg::TeamStop> team_stops_;
  std::optional<Shown> shown_;
  Time next_report_{};
};

}  // namespace galilean::robot
