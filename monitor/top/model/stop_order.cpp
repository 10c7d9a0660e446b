// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/top/model/stop_order.h"

#include <algorithm>

#include "core/plural.h"
#include "monitor/top/model/alarms.h"

namespace galilean::monitor::top {

StopProgress stop_progress(const Team& team, Time ordered, Time now) {
  StopProgress progress;
  const double since_order_s = to_seconds(now - ordered);
  for (const auto& [name, robot] : team.robots()) {
    const bool answers = robot.state && robot.state_received > ordered;
    if (answers && (robot.state->held || robot.state->out_of_service))
      progress.stopped.push_back(name);
    else
      progress.unconfirmed.push_back(
          {name, answers ? since_order_s : std::max(team.age_s(robot), since_order_s), answers});
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
