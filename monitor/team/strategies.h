// SPDX-License-Identifier: BSD-3-Clause
#pragma once

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
};

/// Credits the referee's counts of each robot to the program that the robot ran, so that programs
/// which took turns in one contest can be compared. A contest clock that goes back begins a new
/// contest. Depends on the messages only.
class StrategyTally {
 public:
  void note(const msg::RobotState& state);
  void note(const msg::Score& score);

  /// Returns the contest's programs in the order in which they were first credited.
  [[nodiscard]] const std::vector<Strategy>& strategies() const noexcept { return strategies_; }

 private:
  struct Running {
    std::string name;
    std::string hash;
    bool out_of_service = false;
  };

  void credit(const msg::RobotScore& now, const msg::Score& score, double passed_s);
  Strategy& strategy_of(const Running& running);
  [[nodiscard]] msg::RobotScore last_of(const std::string& robot) const;

  std::map<std::string, Running> running_;  ///< by robot
  msg::Score last_;
  bool has_last_ = false;
  std::vector<Strategy> strategies_;
};

}  // namespace galilean::monitor
