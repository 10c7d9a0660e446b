// SPDX-License-Identifier: BSD-3-Clause
#include "sim/camera/view.h"

#include <cmath>

namespace galilean::sim {
namespace {

using Vec2f = Eigen::Vector2f;
constexpr float kFieldLines = 264;

/// Moves `point` along the line to `other` until it is in front of the camera. Returns the share of
/// the line that was cut off.
float clip_near(Vec2f& point, const Vec2f& other) {
  if (point.y() >= View::kNearest_m) return 0;
  const float share = (View::kNearest_m - point.y()) / (other.y() - point.y());
  point += share * (other - point);
  return share;
}

}  // namespace

View::View(const CameraGeometry& camera, const Pose2& robot) noexcept
    : ahead_(unit_vector(robot.heading_rad).cast<float>()),
      fx_(static_cast<float>(camera.width_px / 2.0 / std::tan(camera.view_angle_rad / 2))),
      fy_(fx_ * static_cast<float>(camera.height_px) / kFieldLines),
      centre_column_(static_cast<float>(camera.width_px) / 2),
      centre_row_(static_cast<float>(camera.height_px) / 2),
      camera_height_m_(static_cast<float>(camera.height_m)) {
  position_m_ = robot.position_m.cast<float>() + static_cast<float>(camera.forward_m) * ahead_;
}

std::optional<ProjectedFace> View::project(const Vec2f& a_m, const Vec2f& b_m) const noexcept {
  Vec2f a = to_camera(a_m);
  Vec2f b = to_camera(b_m);
  const bool shows_back = a.x() * b.y() >= b.x() * a.y();
  if (shows_back || (a.y() < kNearest_m && b.y() < kNearest_m)) return std::nullopt;
  const float length_m = (b - a).norm();
  const float cut_left = clip_near(a, b);
  const float cut_right = clip_near(b, a);
  ProjectedFace face;
  face.left_px = column(a.x(), a.y());
  face.right_px = column(b.x(), b.y());
  if (face.right_px <= 0 || face.left_px >= 2 * centre_column_ ||
      face.right_px - face.left_px < 0.01f)
    return std::nullopt;
  face.inverse_left = 1 / a.y();
  face.inverse_right = 1 / b.y();
  face.along_left_m = cut_left * length_m;
  face.along_right_m = (1 - cut_right) * length_m;
  return face;
}

}  // namespace galilean::sim
