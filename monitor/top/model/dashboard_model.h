// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <optional>
#include <string>

#include "core/wire/messages.h"
#include "monitor/team/team.h"

namespace galilean::monitor::top {

/// The newest messages that the dashboard shows: the team, the map's objects, the occupancy grid
/// and the robots' sightings.
class DashboardModel {
 public:
  explicit DashboardModel(const Clock& clock) : clock_(clock), team_(clock) {}

  /// Handles a message of any type. Ignores messages that it does not show or cannot decode.
  void receive(const Message& message);

  [[nodiscard]] const Team& team() const noexcept { return team_; }
  /// Returns the map's objects; nullptr if no message with them came in the last 5 s.
  [[nodiscard]] const msg::ObjectMap* objects() const noexcept;
  [[nodiscard]] Time objects_received() const noexcept {
    return objects_ ? objects_->received : Time{};
  }
  /// Returns the newest occupancy grid; nullptr if none has come yet.
  [[nodiscard]] const msg::OccupancyGrid* floor() const noexcept;
  /// Returns a robot's newest sightings; nullptr if it sent none in the last 5 s.
  [[nodiscard]] const msg::Sightings* sightings(const std::string& robot) const noexcept;

 private:
  template <class M>
  struct Heard {
    M message;
    Time received;
  };
  template <class M>
  bool note(const Message& message, std::optional<Heard<M>>& to);

  const Clock& clock_;
  Team team_;
  std::optional<Heard<msg::ObjectMap>> objects_;
  std::optional<Heard<msg::OccupancyGrid>> floor_;
  std::map<std::string, std::optional<Heard<msg::Sightings>>> sightings_;  ///< by topic
};

}  // namespace galilean::monitor::top
