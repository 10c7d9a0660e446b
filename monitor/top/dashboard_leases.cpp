// SPDX-License-Identifier: BSD-3-Clause
// Who steers the robots through the monitor, and taking turns.
#include <utility>

#include "monitor/top/dashboard.h"

namespace galilean::monitor::top {

void Dashboard::take_turns() {
  const std::string robot = shown_robot();
  const auto lease = pusher_.lease(robot);
  if (!lease) return notices_.tell_of_now("No other operator steers " + robot + ".");
  if (lease->is_yours && lease->asker.empty())
    return notices_.tell_of_now("You steer " + robot + ", and nobody asks for it.");
  if (lease->is_asked_by_you)
    return notices_.tell_of_now(lease->holder + " was asked for " + robot + " already.");
  pusher_.change_lease(lease->is_yours ? "give" : "ask", robot, {});
  notices_.tell_of_now(lease->is_yours ? "gave " + robot + " to " + lease->asker
                                       : "asked " + lease->holder + " for " + robot +
                                             "; unless it is refused, it is yours in 10 s");
}

void Dashboard::insist() {
  const std::string robot = shown_robot();
  const auto lease = pusher_.lease(robot);
  if (!lease) return notices_.tell_of_now("No other operator steers " + robot + ".");
  if (lease->is_yours && lease->asker.empty())
    return notices_.tell_of_now("You steer " + robot + ", and nobody asks for it.");
  if (lease->is_yours) {
    pusher_.change_lease("refuse", robot, {});
    return notices_.tell_of_now("kept " + robot + ", and told " + lease->asker);
  }
  wanted_robot_ = robot;
  reason_.clear();
  begin_text(Mode::kReason);
}

void Dashboard::take_over() {
  if (reason_.empty()) return notices_.tell_of_now("Nothing was taken over without a reason.");
  pusher_.change_lease("take", wanted_robot_, reason_);
  notices_.tell_of_now("took " + wanted_robot_ + " over; all operators see why");
}

bool Dashboard::may_steer(const std::string& robot, bool all) {
  for (const auto& [name, known] : model_.team().robots()) {
    if (!all && name != robot) continue;
    const auto lease = pusher_.lease(name);
    if (!lease || lease->is_yours || model_.team().replayed(known)) continue;
    notices_.tell_of_now(lease->holder + " steers " + name + ": m asks for it, M takes it over");
    return false;
  }
  return true;
}

std::string Dashboard::asked_for() const {
  for (const auto& [name, known] : model_.team().robots())
    if (const auto lease = pusher_.lease(name); lease && lease->is_yours && !lease->asker.empty())
      return lease->asker + " asks for " + name +
             ", and gets it in 10 s: choose it, then m gives it, M refuses";
  return {};
}

}  // namespace galilean::monitor::top
