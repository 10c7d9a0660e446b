// SPDX-License-Identifier: BSD-3-Clause
#include "robot/motor/move_to_goal.h"

#include "robot/variables/relative.h"

namespace galilean::robot {

void MoveToGoal::describe(Declaration<MoveToGoal>& is) {
  is.help("Pulls the robot towards a located object.");
  is.reads(&MoveToGoal::shaft_, "shaft_variable", "where the robot is");
  is.reads(&MoveToGoal::goal_, "goal_variable", "what to move to");
  is.number(&MoveToGoal::success_radius_m_, "success_radius", unit::kCentimetre, 20,
            "distance within which the goal no longer pulls")
      .range(0, 10000);
  is.writes(&MoveToGoal::result_, "result", "the force towards the goal");
}

void MoveToGoal::run(const Tick& tick) {
  const auto goal = relative_object(*goal_, *shaft_, tick.now);
  if (!goal) return;
  const double strength = goal->distance_m > success_radius_m_ ? 1 : 0;
  result_->write({goal->towards() * strength}, goal->certainty, tick.now, tick.number);
}

}  // namespace galilean::robot
