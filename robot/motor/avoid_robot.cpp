// SPDX-License-Identifier: BSD-3-Clause
#include "robot/motor/avoid_robot.h"

#include "robot/motor/potential.h"
#include "robot/variables/relative.h"

namespace galilean::robot {

void AvoidRobot::describe(Declaration<AvoidRobot>& is) {
  is.help("Pushes the robot away from another robot, so that a team spreads.");
  is.reads(&AvoidRobot::shaft_, "shaft_variable", "where the robot is");
  is.reads(&AvoidRobot::robot_, "robot_variable", "the other robot");
  is.number(&AvoidRobot::min_sphere_m_, "min_sphere", unit::kCentimetre, 50,
            "distance within which the repulsion is max_repulsion")
      .range(0, 10000);
  is.number(&AvoidRobot::max_sphere_m_, "max_sphere", unit::kCentimetre, 150,
            "distance from which on there is no repulsion")
      .range(0, 10000);
  is.number(&AvoidRobot::max_repulsion_, "max_repulsion", unit::kNone, 100,
            "the force inside min_sphere; just outside it the force is 1")
      .range(0, 1e6);
  is.writes(&AvoidRobot::result_, "result", "the force away from the other robot");
}

void AvoidRobot::run(const Tick& tick) {
  const auto other = relative_object(*robot_, *shaft_, tick.now);
  if (!other) return;
  result_->write({other->away() * strength(other->distance_m)}, other->certainty, tick.now,
                 tick.number);
}

double AvoidRobot::strength(double distance_m) const noexcept {
  if (distance_m <= min_sphere_m_) return max_repulsion_;
  return linear_repulsion(distance_m, min_sphere_m_, max_sphere_m_, 1);
}

}  // namespace galilean::robot
