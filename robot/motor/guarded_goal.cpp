// SPDX-License-Identifier: BSD-3-Clause
#include "robot/motor/guarded_goal.h"

#include "robot/variables/relative.h"

namespace galilean::robot {

void GuardedGoal::describe(Declaration<GuardedGoal>& is) {
  is.help("Pulls the robot towards a located object and slows it down on arrival.");
  is.reads(&GuardedGoal::shaft_, "shaft_variable", "where the robot is");
  is.reads(&GuardedGoal::goal_, "goal_variable", "what to move to");
  is.number(&GuardedGoal::drop_radius_m_, "drop_radius", unit::kCentimetre, 40,
            "distance from which on the pull falls")
      .range(0, 10000);
  is.number(&GuardedGoal::dead_radius_m_, "dead_radius", unit::kCentimetre, 10,
            "distance within which the goal no longer pulls")
      .range(0, 10000);
  is.writes(&GuardedGoal::result_, "result", "the force towards the goal");
}

void GuardedGoal::run(const Tick& tick) {
  const auto goal = relative_object(*goal_, *shaft_, tick.now);
  if (!goal) return;
  result_->write({goal->towards() * strength(goal->distance_m)}, goal->certainty, tick.now,
                 tick.number);
}

double GuardedGoal::strength(double distance_m) const noexcept {
  if (distance_m <= dead_radius_m_) return 0;
  if (distance_m > drop_radius_m_) return 1;
  return (distance_m - dead_radius_m_) / (drop_radius_m_ - dead_radius_m_);
}

}  // namespace galilean::robot
