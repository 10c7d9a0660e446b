// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <optional>

#include "core/device/camera_geometry.h"
#include "core/geometry.h"

namespace galilean::sim {

/// A face on the image plane. Columns and rows are continuous: pixel i covers [i, i + 1).
/// 1/depth is linear in the column, and so are both edges of every band.
struct ProjectedFace {
  float left_px = 0;
  float right_px = 0;
  float inverse_left = 0;  ///< 1/depth at `left_px`, 1/m
  float inverse_right = 0;
  float along_left_m = 0;  ///< where on the face, from its point a
  float along_right_m = 0;

  [[nodiscard]] float slope() const noexcept {
    return (inverse_right - inverse_left) / (right_px - left_px);
  }
  [[nodiscard]] float inverse_at(float column) const noexcept {
    return inverse_left + slope() * (column - left_px);
  }
};

/// The pinhole camera of one robot at one moment:
///   column = width/2 + fx · x/z,   row = height/2 + fy · (camera height - y)/z
/// with x to the right and z ahead of the camera, y over the floor. NTSC's 264 lines of a field are
/// squeezed into the image's height, hence fy = fx · height / 264.
class View {
 public:
  View(const CameraGeometry& camera, const Pose2& robot) noexcept;

  /// Returns the point with x to the right and y ahead.
  [[nodiscard]] Eigen::Vector2f to_camera(const Eigen::Vector2f& arena_m) const noexcept {
    const Eigen::Vector2f d = arena_m - position_m_;
    return {d.x() * ahead_.y() - d.y() * ahead_.x(), d.dot(ahead_)};
  }
  /// Returns the projected line from a to b, or nothing if it is out of view or shows its back.
  [[nodiscard]] std::optional<ProjectedFace> project(const Eigen::Vector2f& a_m,
                                                     const Eigen::Vector2f& b_m) const noexcept;

  [[nodiscard]] float row(float height_m, float inverse_depth) const noexcept {
    return centre_row_ + fy_ * (camera_height_m_ - height_m) * inverse_depth;
  }
  [[nodiscard]] float column(float right_m, float depth_m) const noexcept {
    return centre_column_ + fx_ * right_m / depth_m;
  }
  /// Returns how many metres to the right the column's ray goes for each metre ahead.
  [[nodiscard]] float tangent(float column) const noexcept {
    return (column - centre_column_) / fx_;
  }
  /// Returns the depth at which the row shows the floor. Requires: the row is below the horizon.
  [[nodiscard]] float floor_depth_m(float row) const noexcept {
    return fy_ * camera_height_m_ / (row - centre_row_);
  }
  [[nodiscard]] float camera_height_m() const noexcept { return camera_height_m_; }
  [[nodiscard]] float focal_columns_px() const noexcept { return fx_; }
  [[nodiscard]] float horizon_row() const noexcept { return centre_row_; }
  [[nodiscard]] const Eigen::Vector2f& position_m() const noexcept { return position_m_; }

  static constexpr float kNearest_m = 0.04f;

 private:
  Eigen::Vector2f position_m_;
  Eigen::Vector2f ahead_;
  float fx_;
  float fy_;
  float centre_column_;
  float centre_row_;
  float camera_height_m_;
};

}  // namespace galilean::sim
