// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "core/clock.h"
#include "monitor/ingest/channel.h"
#include "monitor/ingest/robot_roster.h"
#include "monitor/team/robot.h"
#include "monitor/team/strategies.h"

namespace galilean::monitor {

/// A model of the team: every robot that ever sent a message, by name, and the referee's score. A
/// robot that falls silent stays until `forget` is called for it, and so does one that fell silent
/// before this began, if a monitor tells of it. The model depends on the messages and the clock
/// only. For use by one thread.
class Team {
 public:
  static constexpr Duration kDefaultSilentAfter = std::chrono::seconds(2);
  /// A robot's clock that is more than this ahead is a problem that is told.
  static constexpr double kClockAhead_s = 5;
  /// Robots that only another monitor tells of are not added beyond so many.
  static constexpr std::size_t kMostRobots = RobotRoster::kMost;

  /// A robot counts as silent if its last message is older than `silent_after`.
  /// Requires: `clock` outlives this.
  explicit Team(const Clock& clock, Duration silent_after = kDefaultSilentAfter)
      : clock_(clock), silent_after_(silent_after) {}

  /// Handles a message of any type, and ignores those that are not about robots or the score.
  /// Returns false if the bytes cannot be decoded as the message's type.
  bool receive(const Message& message);

  void note(msg::RobotState state);
  /// `filled`: it fills a gap in which the robot could not be heard.
  void note(const msg::Transition& transition, bool filled = false);
  void note(msg::Variables variables);
  void note(const msg::Program& program);
  void note(const msg::Catalog& catalog);
  void note(const msg::Breaks& breaks);
  /// Notes which program a robot runs after the reply. It does not count as heard by that, because
  /// a late joiner gets old replies, too.
  void note(const msg::ProgramReply& reply);
  void note(const msg::Score& score);
  /// Adds the robots that a monitor knows and that have sent nothing here. They are as old as it
  /// tells, and have no state. Where there are kMostRobots, one that has no state either and is
  /// silent for RobotRoster::kForgetAfter gives its place to one that is not.
  void note(const msg::ObjectMap& map);
  /// Forgets a robot. It is back when it is heard, and not when another monitor still tells of it.
  void forget(const std::string& robot);
  /// Notes that a replay sent a message of the robot, which was noted.
  void note_replay(const std::string& robot) { robots_[robot].replay_heard = clock_.now(); }
  /// Notes how far a live robot's clock is ahead of this machine's. Order in time goes by what is
  /// received, never by stamps, so that it does no harm but to those who read the stamps.
  void note_clock(const std::string& robot, double ahead_s) {
    robots_[robot].clock_ahead_s = ahead_s;
  }
  /// Notes the hash of a program that was pushed to the whole team.
  void note_push(const std::string& hash) { pushed_hash_ = hash; }

  /// Returns the robots in the order of their names. The reference is valid as long as this object,
  /// and the next message changes the map.
  [[nodiscard]] const std::map<std::string, Robot, std::less<>>& robots() const noexcept {
    return robots_;
  }
  /// Returns the robot of this name, or nullptr if nobody told of it.
  [[nodiscard]] const Robot* find(std::string_view robot) const noexcept;
  [[nodiscard]] const std::optional<msg::Score>& score() const noexcept { return score_; }

  [[nodiscard]] const std::vector<Strategy>& strategies() const noexcept {
    return tally_.strategies();
  }
  /// Returns how many programs were dropped with their score; see StrategyTally.
  [[nodiscard]] std::uint64_t strategies_dropped() const noexcept { return tally_.dropped(); }

  [[nodiscard]] RobotStatus status(const Robot& robot) const;
  [[nodiscard]] std::vector<RobotStatus> statuses() const;
  [[nodiscard]] bool silent(const Robot& robot) const noexcept;
  /// Returns whether what was heard of the robot lately came from a recording, all of it or a part.
  [[nodiscard]] bool replayed(const Robot& robot) const noexcept;
  /// Returns the names of the robots that are replayed, in their order.
  [[nodiscard]] std::vector<std::string> replayed() const;
  [[nodiscard]] double age_s(const Robot& robot) const noexcept;
  /// Returns the hash of the program that the team should run: the last one that was pushed to all,
  /// if any robot runs it, else the one that most robots run. Robots that a recording plays count
  /// where there are no others. Returns an empty string while no robot's program is known.
  [[nodiscard]] std::string program_hash() const;
  /// Returns the present certainty of one of the robot's variables, from 0 to 1.
  [[nodiscard]] double certainty_now(const Robot& robot, const msg::Variable& variable) const {
    return certainty_after(variable, clock_.now() - robot.variables_received);
  }
  /// Returns the time since the robot told where it stops.
  [[nodiscard]] Duration since_breaks(const Robot& robot) const noexcept {
    return clock_.now() - robot.breaks_received;
  }

 private:
  [[nodiscard]] RobotStatus status(const Robot& robot, const std::string& team_hash) const;
  Robot& hear(const std::string& robot);
  /// Returns whether a robot that another monitor tells of can be added. Forgets one for it if that
  /// must be.
  [[nodiscard]] bool has_room_for(const msg::MapRobot& told);
  /// Returns how many robots run each program, by its hash: those that a recording plays, or the
  /// others.
  [[nodiscard]] std::map<std::string, int> votes(bool of_recordings) const;

  const Clock& clock_;
  Duration silent_after_;
  std::map<std::string, Robot, std::less<>> robots_;
  std::set<std::string, std::less<>> forgotten_;  ///< some of those that were not heard since
  std::optional<msg::Score> score_;
  StrategyTally tally_;
  std::string pushed_hash_;
};

}  // namespace galilean::monitor
