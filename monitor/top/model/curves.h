// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <deque>
#include <string>
#include <utility>
#include <vector>

#include "monitor/team/robot.h"
#include "monitor/top/model/history.h"

namespace galilean::monitor::top {

/// The curves of a robot's variables, made of what the history keeps. It remembers the samples that
/// it has decoded, because they come twice a second, and screens ten times.
class Curves {
 public:
  /// Requires: `history` outlives this.
  explicit Curves(const History& history) : history_(history) {}

  /// Returns the curve of each of the robot's variables, in their order, up to `then`: the oldest
  /// number first, NaN where the variable was invalid.
  [[nodiscard]] std::vector<std::vector<double>> of(const Robot& robot, Time then);

 private:
  /// The numbers of one message, by the variables' names.
  struct Point {
    Payload cdr;
    std::vector<std::pair<std::string, double>> numbers;
  };

  void recall(const std::vector<History::Sample>& samples);

  const History& history_;
  std::deque<Point> points_;  ///< of the robot that was asked for last
};

}  // namespace galilean::monitor::top
