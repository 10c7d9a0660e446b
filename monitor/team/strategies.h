// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "core/wire/messages.h"

namespace galilean::monitor {

/// The score of one program in this contest, over all robots that ran it.
struct Strategy {
  std::string program_name;
  std::string program_hash;
  double robot_seconds = 0;  ///< contest time that robots ran it; two robots count twice
  unsigned deposited = 0;
  unsigned collisions = 0;
  double points = 0;
  std::uint64_t last_credited = 0;  ///< rises with each credit of any program
};

/// Credits the referee's counts of each robot to the program that the robot ran, so that programs
/// which took turns in one contest can be compared. A contest clock that goes back begins a new
/// contest. Depends on the messages only.
///
/// Whoever writes to DDS can invent programs and robots. It therefore keeps the kMostStrategies
/// programs that were credited most recently in the contest, and the programs of the kMostRobots
/// robots that were heard most recently.
class StrategyTally {
 public:
  static constexpr std::size_t kMostStrategies = 64;
  static constexpr std::size_t kMostRobots = 256;

  void note(const msg::RobotState& state);
  void note(const msg::Score& score);
  void forget(const std::string& robot) { running_.erase(robot); }

  /// Returns the contest's programs in the order in which they were first credited.
  [[nodiscard]] const std::vector<Strategy>& strategies() const noexcept { return strategies_; }
  /// Returns how many programs were dropped with their score, of all contests, because newer ones
  /// needed their places.
  [[nodiscard]] std::uint64_t dropped() const noexcept { return dropped_; }

 private:
  struct Running {
    std::string name;
    std::string hash;
    bool out_of_service = false;
    std::uint64_t noted = 0;  ///< by number of the message
  };

  void credit(const msg::RobotScore& now, const msg::Score& score, double passed_s);
  Strategy& strategy_of(const Running& running);
  [[nodiscard]] msg::RobotScore last_of(const std::string& robot) const;

  std::map<std::string, Running> running_;  ///< by robot
  std::uint64_t noted_ = 0, credited_ = 0;  ///< counts what came, which tells the newest
  std::uint64_t dropped_ = 0;
  msg::Score last_;
  bool has_last_ = false;
  std::vector<Strategy> strategies_;
};

}  // namespace galilean::monitor
