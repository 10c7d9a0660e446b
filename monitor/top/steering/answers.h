// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "core/clock.h"
#include "monitor/team/team.h"

namespace galilean::monitor::top {

/// Waits for robots' answers to the orders that they may refuse: steps, orders about break points,
/// and commands that a robot takes only from those whom it trusts.
class Answers {
 public:
  static constexpr Duration kMost = std::chrono::seconds(2);

  /// Waits for the answer of each robot to an order that was sent now. `effect` says what the order
  /// does to a robot that carries it out, such as "stops on entering grab"; empty: that shows.
  void expect(const std::string& id, const std::string& effect, std::vector<std::string> robots,
              Time now);
  /// Waits for refusals of an order that was sent now, to which a robot says nothing if it obeys.
  void expect_refusals(const std::string& id, std::vector<std::string> robots, Time now);
  /// Returns what came of the orders since the last call, in a sentence: who did what, who refused
  /// and why, and who has not answered in time. Returns an empty string if nothing did.
  [[nodiscard]] std::string take(const Team& team, Time now);

 private:
  struct Open {
    std::string id, effect;
    std::vector<std::string> robots;  ///< those that have not answered
    Time sent;
    bool silence_is_consent = false;
  };

  std::vector<Open> open_;  ///< the oldest first
};

}  // namespace galilean::monitor::top
