// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <numbers>

namespace galilean {

using Vec2 = Eigen::Vector2d;
using Mat2 = Eigen::Matrix2d;

inline constexpr double kPi = std::numbers::pi;

/// Where a body is on the floor and which way it faces, in a global frame ("odom" or "map").
/// `heading_rad` is counter-clockwise from the frame's x axis to the body's forward axis (REP 103).
struct Pose2 {
  Vec2 position_m = Vec2::Zero();
  double heading_rad = 0;
};

/// Returns the same angle in (-pi, pi] [rad].
[[nodiscard]] double wrap_angle(double angle_rad) noexcept;

/// Returns the unit vector at `angle_rad` counter-clockwise from x.
[[nodiscard]] Vec2 unit_vector(double angle_rad) noexcept;

/// Returns `vector` turned counter-clockwise by `angle_rad`.
[[nodiscard]] Vec2 rotated(const Vec2& vector, double angle_rad) noexcept;

/// Returns `vector`, shortened to `max_length` if it is longer. Its direction stays.
[[nodiscard]] Vec2 clipped(const Vec2& vector, double max_length) noexcept;

/// These four functions convert between the paper's robot frame (x right, y forward) and the global
/// frame of the pose `robot`. Directions are only turned. Points [m] are also moved by the robot's
/// position.
[[nodiscard]] Vec2 direction_to_global(const Pose2& robot, const Vec2& in_robot) noexcept;
[[nodiscard]] Vec2 direction_to_robot(const Pose2& robot, const Vec2& in_global) noexcept;
[[nodiscard]] Vec2 point_to_global(const Pose2& robot, const Vec2& in_robot_m) noexcept;
[[nodiscard]] Vec2 point_to_robot(const Pose2& robot, const Vec2& in_global_m) noexcept;

/// Returns the counter-clockwise angle [rad] from straight ahead to a direction in the robot frame
/// (x right, y forward), in (-pi, pi].
[[nodiscard]] double bearing_rad(const Vec2& in_robot) noexcept;

}  // namespace galilean
