// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "core/device/camera_geometry.h"
#include "core/geometry.h"

namespace galilean::robot {

/// A place on the floor, computed from one pixel.
struct FloorPoint {
  Vec2 in_robot_m = Vec2::Zero();     ///< robot frame (x right, y forward), from its centre
  Mat2 covariance_m2 = Mat2::Zero();  ///< robot frame
  double depth_m = 0;                 ///< from the camera, along its axis
  double range_m = 0;                 ///< from the camera, along the floor
  double range_error_m = 0;           ///< how much one row of pixels changes the range
  double azimuth_rad = 0;             ///< counter-clockwise from straight ahead
};

/// Picture to floor and back, for a horizontal pinhole camera. Columns and rows are continuous
/// here: pixel i reaches from i to i + 1, and the optical axis meets the picture in its middle.
///   focal lengths  fx = (w/2) / tan(view/2); fy = fx · h / (3/4 · w): the picture is 4:3, its
///                  pixels are not square
///   azimuth        atan((w/2 - column) / fx)
///   depth          h / tan(theta), tan(theta) = (row - h_px/2) / fy; range = depth / cos(azimuth)
///   covariance     one row: depth · range / (camera height · fy) along the ray; one column:
///                  range · cos²(azimuth) / fx across it; each with 1 cm of the mounting's own
///   source         the paper, whose arctan in the range is a misprint
class CameraModel {
 public:
  explicit CameraModel(const CameraGeometry& geometry) noexcept;

  [[nodiscard]] double azimuth_rad(double column) const noexcept;
  /// Returns where the ray through this point of the picture meets the floor, moved `deeper_m`
  /// along that ray, measured along the camera's axis. With a round object's radius this leads from
  /// its foremost point to its centre. Returns nothing at the horizon or above.
  [[nodiscard]] std::optional<FloorPoint> floor_point(double column, double row,
                                                      double deeper_m) const noexcept;
  /// Returns the height over the floor of a thing that is seen at `row` and stands `depth_m` away.
  [[nodiscard]] double height_m(double row, double depth_m) const noexcept;
  /// Returns the width of a thing that covers this many columns `depth_m` away.
  [[nodiscard]] double width_m(double columns, double depth_m) const noexcept;

  /// Where a point on the floor is seen. There is none if the point is not in front of the camera.
  struct Pixel {
    double column, row;
  };
  [[nodiscard]] std::optional<Pixel> pixel(const Vec2& in_robot_m) const noexcept;
  /// Returns whether the point is inside the picture, at least `margin_px` from its edges.
  [[nodiscard]] bool sees(const Vec2& in_robot_m, double margin_px) const noexcept;

  [[nodiscard]] const CameraGeometry& geometry() const noexcept { return geometry_; }
  [[nodiscard]] Vec2 in_robot_m() const noexcept { return {0, geometry_.forward_m}; }

 private:
  CameraGeometry geometry_;
  double fx_px_;
  double fy_px_;
};

}  // namespace galilean::robot
