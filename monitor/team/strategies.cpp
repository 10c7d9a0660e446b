// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/team/strategies.h"

#include <algorithm>

namespace galilean::monitor {

void StrategyTally::note(const msg::RobotState& state) {
  if (state.program_hash.empty()) return;
  running_[state.robot] = {state.program_name, state.program_hash, state.out_of_service, ++noted_};
  if (running_.size() <= kMostRobots) return;
  running_.erase(std::min_element(
      running_.begin(), running_.end(),
      [](const auto& a, const auto& b) { return a.second.noted < b.second.noted; }));
}

void StrategyTally::note(const msg::Score& score) {
  const bool new_contest = has_last_ && score.elapsed_s < last_.elapsed_s;
  if (new_contest) {
    strategies_.clear();
    has_last_ = false;
  }
  // The counts of the first message are credited to no program, because it is unknown which
  // programs ran before it.
  if (has_last_)
    for (const auto& robot : score.robots) credit(robot, score, score.elapsed_s - last_.elapsed_s);
  last_ = score;
  has_last_ = true;
}

void StrategyTally::credit(const msg::RobotScore& now, const msg::Score& score, double passed_s) {
  const auto found = running_.find(now.robot);
  if (found == running_.end()) return;
  const msg::RobotScore before = last_of(now.robot);
  const unsigned deposited = now.deposited - std::min(before.deposited, now.deposited);
  const unsigned collisions = now.collisions - std::min(before.collisions, now.collisions);
  if (passed_s <= 0 && deposited == 0 && collisions == 0) return;
  Strategy& strategy = strategy_of(found->second);
  strategy.last_credited = ++credited_;
  if (!found->second.out_of_service) strategy.robot_seconds += passed_s;
  strategy.deposited += deposited;
  strategy.collisions += collisions;
  strategy.points += deposited * score.points_per_piece + collisions * score.points_per_collision;
}

Strategy& StrategyTally::strategy_of(const Running& running) {
  const auto found = std::ranges::find(strategies_, running.hash, &Strategy::program_hash);
  if (found != strategies_.end()) return *found;
  if (strategies_.size() >= kMostStrategies) {
    ++dropped_;
    strategies_.erase(std::ranges::min_element(strategies_, {}, &Strategy::last_credited));
  }
  return strategies_.emplace_back(
      Strategy{.program_name = running.name, .program_hash = running.hash});
}

msg::RobotScore StrategyTally::last_of(const std::string& robot) const {
  const auto found = std::ranges::find(last_.robots, robot, &msg::RobotScore::robot);
  return found == last_.robots.end() ? msg::RobotScore{} : *found;
}

}  // namespace galilean::monitor
