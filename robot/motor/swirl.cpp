// SPDX-License-Identifier: BSD-3-Clause
#include "robot/motor/swirl.h"

#include "robot/motor/potential.h"
#include "robot/variables/relative.h"

namespace galilean::robot {

void Swirl::describe(Declaration<Swirl>& is) {
  is.help("Leads the robot around an obstacle, on the side that it already tends to.");
  is.reads(&Swirl::shaft_, "shaft_variable", "where the robot is");
  is.reads(&Swirl::obstacle_, "obstacle_variable", "what to go around");
  is.number(&Swirl::min_sphere_m_, "min_sphere", unit::kCentimetre, 30,
            "distance within which the force is greatest")
      .range(0, 10000);
  is.number(&Swirl::max_sphere_m_, "max_sphere", unit::kCentimetre, 80,
            "distance from which on there is no force")
      .range(0, 10000);
  is.number(&Swirl::max_repulsion_, "max_repulsion", unit::kNone, 1, "the force inside min_sphere")
      .range(0, 1e6);
  is.writes(&Swirl::result_, "result", "the force around the obstacle");
}

void Swirl::run(const Tick& tick) {
  const auto obstacle = relative_object(*obstacle_, *shaft_, tick.now);
  if (!obstacle) return;
  const double strength = linear_repulsion(obstacle->distance_m - obstacle->radius_m, min_sphere_m_,
                                           max_sphere_m_, max_repulsion_);
  const bool on_the_left = bearing_rad(obstacle->in_robot_m) >= 0;
  const Vec2 around = rotated(obstacle->away(), on_the_left ? kPi / 2 : -kPi / 2);
  result_->write({around * strength}, obstacle->certainty, tick.now, tick.number);
}

}  // namespace galilean::robot
