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

/// The same angle in (-pi, pi].
[[nodiscard]] double wrap_angle(double angle_rad) noexcept;

/// Unit vector at `angle_rad` counter-clockwise from x.
[[nodiscard]] Vec2 unit_vector(double angle_rad) noexcept;

/// `vector` turned counter-clockwise by `angle_rad`.
[[nodiscard]] Vec2 rotated(const Vec2& vector, double angle_rad) noexcept;

/// `vector`, shortened to `max_length` if it is longer; its direction stays.
[[nodiscard]] Vec2 clipped(const Vec2& vector, double max_length) noexcept;

/// The paper's robot frame has x to the right and y forward: these four are the only place that
/// knows it. Directions turn only; points also move with the robot's position (metres).
[[nodiscard]] Vec2 direction_to_global(const Pose2& robot, const Vec2& in_robot) noexcept;
[[nodiscard]] Vec2 direction_to_robot(const Pose2& robot, const Vec2& in_global) noexcept;
[[nodiscard]] Vec2 point_to_global(const Pose2& robot, const Vec2& in_robot_m) noexcept;
[[nodiscard]] Vec2 point_to_robot(const Pose2& robot, const Vec2& in_global_m) noexcept;

/// Counter-clockwise angle from straight ahead to a direction in the robot frame, in (-pi, pi].
[[nodiscard]] double bearing_rad(const Vec2& in_robot) noexcept;

}  // namespace galilean
