// SPDX-License-Identifier: BSD-3-Clause
#include "robot/variables/relative.h"

#include <algorithm>

namespace galilean::robot {

Vec2 RelativeObject::away() const noexcept {
  return distance_m > 0 ? Vec2(-in_robot_m / distance_m) : Vec2(0, -1);
}

Vec2 RelativeObject::towards() const noexcept {
  return distance_m > 0 ? Vec2(in_robot_m / distance_m) : Vec2(0, 0);
}

std::optional<RelativeObject> relative_object(const Variable<Locate>& object,
                                              const Variable<Shaft>& shaft, Time now) noexcept {
  const double certainty = std::min(object.certainty_at(now), shaft.certainty_at(now));
  if (certainty <= 0) return std::nullopt;
  RelativeObject result;
  result.in_robot_m = point_to_robot(shaft.value.pose, object.value.position_m);
  result.distance_m = result.in_robot_m.norm();
  result.radius_m = object.value.radius_m;
  result.certainty = certainty;
  return result;
}

bool acts(const Variable<Force>& force, const Tick& tick) noexcept {
  return force.valid_at(tick.now) && (force.constant || force.written_tick == tick.number);
}

}  // namespace galilean::robot
