// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/clock.h"
#include "monitor/ingest/channel.h"
#include "monitor/team/robot.h"
#include "monitor/team/strategies.h"

namespace galilean::monitor {

/// What is known of the team: every robot that was ever heard, by name, and the referee's sheet.
/// Pure: messages go in, answers come out; a robot that falls silent stays, with its age.
class Team {
 public:
  static constexpr Duration kDefaultSilentAfter = std::chrono::seconds(2);

  explicit Team(const Clock& clock, Duration silent_after = kDefaultSilentAfter)
      : clock_(clock), silent_after_(silent_after) {}

  /// Takes any message; those that tell nothing of a robot or the score are let pass. False if its
  /// bytes were no message of its type.
  bool receive(const Message& message);

  void note(const msg::RobotState& state);
  void note(const msg::Transition& transition);
  void note(const msg::Variables& variables);
  void note(const msg::Program& program);
  void note(const msg::Catalog& catalog);
  void note(const msg::Score& score);
  /// A program was pushed to the whole team.
  void note_push(const std::string& hash) { pushed_hash_ = hash; }

  /// In the order of their names. Valid until the next message.
  [[nodiscard]] const std::map<std::string, Robot, std::less<>>& robots() const noexcept {
    return robots_;
  }
  [[nodiscard]] const Robot* find(std::string_view robot) const noexcept;
  [[nodiscard]] const std::optional<msg::Score>& score() const noexcept { return score_; }

  [[nodiscard]] const std::vector<Strategy>& strategies() const noexcept {
    return tally_.strategies();
  }

  [[nodiscard]] RobotStatus status(const Robot& robot) const;
  [[nodiscard]] std::vector<RobotStatus> statuses() const;
  [[nodiscard]] bool silent(const Robot& robot) const noexcept;
  [[nodiscard]] double age_s(const Robot& robot) const noexcept;
  /// The program that the team is meant to run: the last one pushed to all if any robot took it,
  /// else the one that most robots run. Empty while none is known.
  [[nodiscard]] std::string program_hash() const;
  [[nodiscard]] double certainty_now(const Robot& robot, const msg::Variable& variable) const {
    return certainty_after(variable, clock_.now() - robot.variables_received);
  }

 private:
  Robot& hear(const std::string& robot);

  const Clock& clock_;
  Duration silent_after_;
  std::map<std::string, Robot, std::less<>> robots_;
  std::optional<msg::Score> score_;
  StrategyTally tally_;
  std::string pushed_hash_;
};

}  // namespace galilean::monitor
