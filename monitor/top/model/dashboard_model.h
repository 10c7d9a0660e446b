// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <deque>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "core/wire/messages.h"
#include "monitor/team/team.h"
#include "monitor/top/model/floor.h"
#include "monitor/top/model/identity.h"
#include "monitor/top/model/refusal_watch.h"

namespace galilean::monitor::top {

/// The newest messages that the dashboard shows: the team, the map's objects, the occupancy grid,
/// the robots' sightings and what became of pushes.
class DashboardModel {
 public:
  static constexpr std::size_t kRepliesKept = 128;
  static constexpr std::size_t kPushedNamesKept = 128;

  explicit DashboardModel(const Clock& clock) : clock_(clock), team_(clock) {}

  /// Returns whether the dashboard shows messages of this type.
  [[nodiscard]] static bool shows(std::string_view ros_type) noexcept;
  /// Handles a message of any type. Ignores messages that it does not show or cannot decode.
  void receive(const Message& message);

  /// Takes in what this process did not take in from DDS so far.
  void note(const Intake& intake) { refusals_.look(intake, clock_.now()); }
  /// Forgets a robot that is gone. Its letter may be given to another one.
  void forget(const std::string& robot);

  [[nodiscard]] const Team& team() const noexcept { return team_; }
  [[nodiscard]] const RefusalWatch& refusals() const noexcept { return refusals_; }
  [[nodiscard]] const Identities& identities() const noexcept { return identities_; }
  /// Returns the robots' answers to pushes since this was made, the oldest first.
  [[nodiscard]] const std::deque<msg::ProgramReply>& replies() const noexcept { return replies_; }
  /// Returns the name of the program that a push brought, or an empty string. Those of the newest
  /// kPushedNamesKept pushes are known.
  [[nodiscard]] std::string pushed_name(const std::string& push_id) const;
  /// Returns what the monitor tells to be wrong with its history; empty if nothing is, or if it
  /// told nothing in the last 5 s.
  [[nodiscard]] std::string history_problem() const { return told_lately(history_problem_); }
  /// Returns what a monitor tells to be wrong with its map, in the same way.
  [[nodiscard]] std::string map_problem() const { return told_lately(map_problem_); }
  /// Returns the map's objects; nullptr if no message with them came in the last 5 s.
  [[nodiscard]] const msg::ObjectMap* objects() const noexcept;
  [[nodiscard]] Time objects_received() const noexcept {
    return objects_ ? objects_->received : Time{};
  }
  /// Returns the newest occupancy grid; nullptr if none has come yet.
  [[nodiscard]] const std::shared_ptr<const Floor>& floor() const noexcept { return floor_; }
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

  [[nodiscard]] std::string told_lately(const std::optional<Heard<std::string>>& told) const;
  void note_objects(const Message& message);
  void note_floor(const Message& message);
  void note_reply(const Message& message);
  void note_push(const Message& message);
  void note_diagnostics(const Message& message);

  const Clock& clock_;
  Team team_;
  Identities identities_;
  RefusalWatch refusals_;
  std::deque<msg::ProgramReply> replies_;
  std::map<std::string, std::string> pushed_names_;  ///< by the push's id
  std::optional<Heard<std::string>> history_problem_, map_problem_;
  std::deque<std::string> pushes_;  ///< their ids, the oldest first
  std::optional<Heard<msg::ObjectMap>> objects_;
  std::shared_ptr<const Floor> floor_;
  std::map<std::string, std::optional<Heard<msg::Sightings>>> sightings_;  ///< by topic
};

}  // namespace galilean::monitor::top
