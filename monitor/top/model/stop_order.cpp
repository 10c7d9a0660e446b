// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/top/model/stop_order.h"

#include <algorithm>

#include "core/plural.h"
#include "monitor/top/model/alarms.h"

namespace galilean::monitor::top {

bool StopOrder::is_answered_by(const Robot& robot) const {
  return robot.state && robot.state_received > ordered_;
}

bool StopOrder::is_confirmed_by(const Robot& robot) const {
  const bool at_break_point = robot.breaks && robot.breaks->stopped;
  return is_answered_by(robot) &&
         ((robot.state->held && !at_break_point) || robot.state->out_of_service);
}

void StopOrder::update(const Team& team) {
  for (const auto& [name, robot] : team.robots())
    if (is_confirmed_by(robot)) confirmed_.insert(name);
}

StopProgress StopOrder::progress(const Team& team, Time now) const {
  StopProgress progress;
  const double since_order_s = to_seconds(now - ordered_);
  for (const auto& [name, robot] : team.robots()) {
    if (released_.contains(name) || team.replayed(robot)) continue;  // nobody could stop
    const bool answers = is_answered_by(robot);
    if (confirmed_.contains(name) || is_confirmed_by(robot))
      progress.stopped.push_back(name);
    else
      progress.unconfirmed.push_back(
          {name, answers ? since_order_s : std::max(team.age_s(robot), since_order_s),
           answers && !robot.state->held});
  }
  std::ranges::stable_sort(progress.unconfirmed, std::ranges::greater{}, &Unconfirmed::waits_s);
  return progress;
}

std::string stop_sentence(const StopProgress& progress) {
  constexpr std::size_t kMostNamed = 3;
  const auto& waiting = progress.unconfirmed;
  const std::size_t all = progress.stopped.size() + waiting.size();
  if (all == 0) return "No robot is heard that could stop.";
  if (waiting.empty())
    return all == 1 ? progress.stopped[0] + " has stopped."
                    : "All " + std::to_string(all) + " robots have stopped.";
  std::string text =
      std::to_string(progress.stopped.size()) + " of " + std::to_string(all) + " stopped";
  for (std::size_t i = 0; i < std::min(waiting.size(), kMostNamed); ++i)
    text +=
        (i == 0 ? "; " : ", ") + waiting[i].robot +
        (waiting[i].drives_on ? " answers but has not stopped for " : " has not answered for ") +
        lasting(waiting[i].waits_s);
  if (waiting.size() > kMostNamed)
    text += ", and " + plural(waiting.size() - kMostNamed, "more robot") + " did not confirm";
  return text;
}

}  // namespace galilean::monitor::top
