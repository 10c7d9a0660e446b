// SPDX-License-Identifier: BSD-3-Clause
#include "robot/motor/dock.h"

#include <algorithm>
#include <cmath>

namespace galilean::robot {

void Dock::describe(Declaration<Dock>& is) {
  is.help("Brings the robot to a place from a given side.");
  is.reads(&Dock::shaft_, "shaft_variable", "where the robot is");
  is.reads(&Dock::dock_, "dock_variable", "where to dock");
  is.number(&Dock::approach_heading_rad_, "approach_heading", unit::kDegree, 0,
            "which way the robot faces when it docks, counter-clockwise from the global x axis")
      .range(-360, 360);
  is.number(&Dock::controlled_radius_m_, "controlled_radius", unit::kCentimetre, 100,
            "distance within which the side of approach matters")
      .range(0, 10000);
  is.number(&Dock::cone_rad_, "cone", unit::kDegree, 30,
            "half the angle of the cone in which the robot goes straight in")
      .range(1, 180);
  is.number(&Dock::stop_radius_m_, "stop_radius", unit::kCentimetre, 5,
            "distance within which it has docked and nothing pulls")
      .range(0, 10000);
  is.writes(&Dock::result_, "result", "the force towards the dock");
}

void Dock::run(const Tick& tick) {
  const auto dock = relative_object(*dock_, *shaft_, tick.now);
  if (!dock) return;
  Vec2 force = Vec2::Zero();
  if (dock->distance_m > controlled_radius_m_)
    force = dock->towards();
  else if (dock->distance_m > stop_radius_m_)
    force = controlled_force(*dock);
  result_->write({force}, dock->certainty, tick.now, tick.number);
}

Vec2 Dock::controlled_force(const RelativeObject& dock) const noexcept {
  const Vec2 outwards = direction_to_robot(shaft_->value.pose, -unit_vector(approach_heading_rad_));
  const double phi_rad = wrap_angle(bearing_rad(dock.away()) - bearing_rad(outwards));
  const bool in_cone = std::abs(phi_rad) <= cone_rad_;
  const double goal_part = in_cone ? 1 : dock.distance_m / controlled_radius_m_;
  const double tangential_part = in_cone ? std::abs(phi_rad) / cone_rad_ : 1;
  const Vec2 across = rotated(dock.away(), phi_rad > 0 ? -kPi / 2 : kPi / 2);
  return dock.towards() * goal_part + across * tangential_part;
}

}  // namespace galilean::robot
