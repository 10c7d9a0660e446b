// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/ingest/robot_roster.h"

#include <algorithm>
#include <utility>

namespace galilean::monitor {

RobotRoster::Admission RobotRoster::hear(std::string_view robot, Time now) {
  if (const auto known = heard_.find(robot); known != heard_.end()) {
    known->second = now;
    return {.is_followed = true};
  }
  std::string forgotten;
  if (heard_.size() >= kMost) forgotten = forget_one(now);
  if (heard_.size() >= kMost) return {};
  heard_.emplace(robot, now);
  return {.is_followed = true, .forgotten = std::move(forgotten)};
}

std::string RobotRoster::forget_one(Time now) {
  if (now < next_search_) return {};
  const auto oldest =
      std::min_element(heard_.begin(), heard_.end(),
                       [](const auto& a, const auto& b) { return a.second < b.second; });
  if (now - oldest->second < kForgetAfter) {
    next_search_ = oldest->second + kForgetAfter;
    return {};
  }
  ++forgotten_;
  return heard_.extract(oldest).key();
}

}  // namespace galilean::monitor
