// SPDX-License-Identifier: BSD-3-Clause
#include "core/geometry.h"

#include <cmath>

namespace galilean {

double wrap_angle(double angle_rad) noexcept {
  const double wrapped = std::remainder(angle_rad, 2 * kPi);
  return wrapped <= -kPi ? kPi : wrapped;
}

Vec2 unit_vector(double angle_rad) noexcept {
  return {std::cos(angle_rad), std::sin(angle_rad)};
}

Vec2 rotated(const Vec2& vector, double angle_rad) noexcept {
  const double c = std::cos(angle_rad);
  const double s = std::sin(angle_rad);
  return {c * vector.x() - s * vector.y(), s * vector.x() + c * vector.y()};
}

Vec2 clipped(const Vec2& vector, double max_length) noexcept {
  const double length = vector.norm();
  return length > max_length ? Vec2(vector * (max_length / length)) : vector;
}

Vec2 direction_to_global(const Pose2& robot, const Vec2& in_robot) noexcept {
  return rotated(in_robot, robot.heading_rad - kPi / 2);
}

Vec2 direction_to_robot(const Pose2& robot, const Vec2& in_global) noexcept {
  return rotated(in_global, kPi / 2 - robot.heading_rad);
}

Vec2 point_to_global(const Pose2& robot, const Vec2& in_robot_m) noexcept {
  return robot.position_m + direction_to_global(robot, in_robot_m);
}

Vec2 point_to_robot(const Pose2& robot, const Vec2& in_global_m) noexcept {
  return direction_to_robot(robot, in_global_m - robot.position_m);
}

double bearing_rad(const Vec2& in_robot) noexcept {
  return std::atan2(-in_robot.x(), in_robot.y());
}

}  // namespace galilean
