// SPDX-License-Identifier: BSD-3-Clause
#include "robot/motor/avoid_obstacle.h"

#include "robot/motor/potential.h"
#include "robot/variables/relative.h"

namespace galilean::robot {

void AvoidObstacle::describe(Declaration<AvoidObstacle>& is) {
  is.help("Pushes the robot away from an obstacle, harder the nearer it is.");
  is.reads(&AvoidObstacle::shaft_, "shaft_variable", "where the robot is");
  is.reads(&AvoidObstacle::obstacle_, "obstacle_variable", "what to keep away from");
  is.number(&AvoidObstacle::min_sphere_m_, "min_sphere", unit::kCentimetre, 30,
            "distance within which the repulsion is greatest")
      .range(0, 10000);
  is.number(&AvoidObstacle::max_sphere_m_, "max_sphere", unit::kCentimetre, 80,
            "distance from which on there is no repulsion")
      .range(0, 10000);
  is.number(&AvoidObstacle::max_repulsion_, "max_repulsion", unit::kNone, 100,
            "the force inside min_sphere")
      .range(0, 1e6);
  is.writes(&AvoidObstacle::result_, "result", "the force away from the obstacle");
}

void AvoidObstacle::run(const Tick& tick) {
  const auto obstacle = relative_object(*obstacle_, *shaft_, tick.now);
  if (!obstacle) return;
  const double surface_m = obstacle->distance_m - obstacle->radius_m;
  const double strength = linear_repulsion(surface_m, min_sphere_m_, max_sphere_m_, max_repulsion_);
  result_->write({obstacle->away() * strength}, obstacle->certainty, tick.now, tick.number);
}

}  // namespace galilean::robot
