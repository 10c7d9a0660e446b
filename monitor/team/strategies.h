// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <string>
#include <vector>

#include "core/wire/messages.h"

namespace galilean::monitor {

/// How a program fared in this contest, over all robots that ran it.
struct Strategy {
  std::string program_name;
  std::string program_hash;
  double robot_seconds = 0;  ///< that robots ran it while the clock ran; two robots count twice
  unsigned deposited = 0;
  unsigned collisions = 0;
  double points = 0;
};

/// Credits what the referee counts to the program that the robot ran, so that strategies which
/// took turns in one contest can be compared. A clock that runs back begins a new contest. Pure.
class StrategyTally {
 public:
  void note(const msg::RobotState& state);
  void note(const msg::Score& score);

  /// In the order in which they were first run in the contest.
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
