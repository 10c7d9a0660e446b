// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/pushes/push_order.h"

#include <algorithm>

#include "core/plural.h"

namespace galilean::monitor {
namespace {

bool contains(const std::vector<std::string>& names, const std::string& name) {
  return std::ranges::find(names, name) != names.end();
}

std::string known_robots(const Team& team) {
  std::string names;
  for (const auto& [name, robot] : team.robots()) names += (names.empty() ? "" : ", ") + name;
  return names.empty() ? "no robot was heard yet"
                       : agreeing(team.robots().size(), "known is ", "known are ") + names;
}

/// Adds a robot to the targets. A robot that the order names is awaited even while it is silent.
void add(const Robot& robot, bool is_named, const Team& team, OrderTargets& targets) {
  if (is_named || !team.silent(robot))
    targets.awaited.push_back(target_of(robot));
  else
    targets.silent.push_back(robot.name);
}

}  // namespace

std::vector<std::string> OrderTargets::names() const {
  std::vector<std::string> result;
  for (const auto& target : awaited) result.push_back(target.robot);
  return result;
}

OrderTargets targets_of(const std::vector<std::string>& named, const Team& team) {
  OrderTargets targets;
  for (const auto& [name, robot] : team.robots())
    if (named.empty() ? takes_what_all_take(robot, team) : contains(named, name))
      add(robot, !named.empty(), team, targets);
  return targets;
}

Result<void, Refusal> require_targets(const PushOrder& order, const OrderTargets& targets,
                                      const Team& team) {
  const auto unknown = std::find_if(order.targets.rbegin(), order.targets.rend(),
                                    [&](const auto& name) { return !team.find(name); });
  if (unknown != order.targets.rend())
    return not_found("There is no robot '" + *unknown + "'; " + known_robots(team) + ".");
  for (const auto& name : order.targets)
    if (team.replayed(*team.find(name)))
      return conflict("A recording plays '" + name +
                      "': the robot is not there, and takes no program.");
  if (!order.canary.empty() && !contains(targets.names(), order.canary))
    return conflict("The canary '" + order.canary +
                    "' is none of the robots that are to run the program, or it is silent; " +
                    known_robots(team) + ".");
  if (targets.awaited.empty()) return conflict("No robot is heard; nothing was pushed.");
  return {};
}

std::string runs_now(const PushOrder& order, const OrderTargets& targets, const Team& team) {
  if (order.targets.empty()) return team.program_hash();
  for (const auto& target : targets.awaited)
    if (const Robot* robot = team.find(target.robot)) return robot->running_hash();
  return {};
}

std::optional<Stale> stale(const PushOrder& order, const OrderTargets& targets, const Team& team) {
  if (order.replaces.empty()) return std::nullopt;
  if (order.targets.empty()) {
    // Only the team's program counts. A robot that runs another one gets the team's by this push.
    const auto runs = team.program_hash();
    if (runs.empty() || runs == order.replaces) return std::nullopt;
    return Stale{{}, runs};
  }
  for (const auto& target : targets.awaited) {
    const Robot* robot = team.find(target.robot);
    if (robot && robot->state && robot->running_hash() != order.replaces)
      return Stale{target.robot, robot->running_hash()};
  }
  return std::nullopt;
}

std::string replaced_by_each(const std::string& replaces, const std::vector<Target>& robots,
                             const Team& team) {
  const bool all_run_it = std::ranges::all_of(robots, [&](const Target& target) {
    const Robot* robot = team.find(target.robot);
    return robot && robot->state && robot->running_hash() == replaces;
  });
  return all_run_it ? replaces : std::string();
}

bool overlap(const std::vector<std::string>& targets, const std::vector<std::string>& others) {
  if (targets.empty() || others.empty()) return true;
  return std::ranges::any_of(targets, [&](const auto& name) { return contains(others, name); });
}

}  // namespace galilean::monitor
