// SPDX-License-Identifier: BSD-3-Clause
#include "robot/vision/camera_model.h"

#include <cmath>

namespace galilean::robot {
namespace {

constexpr double kMountingError_m = 0.01;

Mat2 along_and_across(double along_m, double across_m, double azimuth_rad) noexcept {
  const Vec2 ray = unit_vector(kPi / 2 + azimuth_rad);
  const Vec2 side(-ray.y(), ray.x());
  const double mounting_m2 = kMountingError_m * kMountingError_m;
  return (along_m * along_m + mounting_m2) * ray * ray.transpose() +
         (across_m * across_m + mounting_m2) * side * side.transpose();
}

}  // namespace

CameraModel::CameraModel(const CameraGeometry& geometry) noexcept
    : geometry_(geometry),
      fx_px_(geometry.width_px / 2.0 / std::tan(geometry.view_angle_rad / 2)),
      fy_px_(fx_px_ * geometry.height_px / (geometry.width_px * 3.0 / 4)) {}

double CameraModel::azimuth_rad(double column) const noexcept {
  return std::atan((geometry_.width_px / 2.0 - column) / fx_px_);
}

std::optional<FloorPoint> CameraModel::floor_point(double column, double row,
                                                   double deeper_m) const noexcept {
  const double below_horizon_px = row - geometry_.height_px / 2.0;
  if (below_horizon_px <= 0) return std::nullopt;
  FloorPoint point;
  point.azimuth_rad = azimuth_rad(column);
  point.depth_m = geometry_.height_m * fy_px_ / below_horizon_px;
  point.range_m = point.depth_m / std::cos(point.azimuth_rad);
  point.range_error_m = point.depth_m * point.range_m / (geometry_.height_m * fy_px_);
  const double column_error_rad = std::pow(std::cos(point.azimuth_rad), 2) / fx_px_;
  point.covariance_m2 =
      along_and_across(point.range_error_m, point.range_m * column_error_rad, point.azimuth_rad);
  point.range_m += deeper_m / std::cos(point.azimuth_rad);
  point.in_robot_m = in_robot_m() + point.range_m * unit_vector(kPi / 2 + point.azimuth_rad);
  return point;
}

double CameraModel::height_m(double row, double depth_m) const noexcept {
  return geometry_.height_m + (geometry_.height_px / 2.0 - row) * depth_m / fy_px_;
}

double CameraModel::width_m(double columns, double depth_m) const noexcept {
  return columns * depth_m / fx_px_;
}

std::optional<CameraModel::Pixel> CameraModel::pixel(const Vec2& in_robot) const noexcept {
  const Vec2 from_camera = in_robot - in_robot_m();
  if (from_camera.y() <= 0) return std::nullopt;
  return Pixel{geometry_.width_px / 2.0 + fx_px_ * from_camera.x() / from_camera.y(),
               geometry_.height_px / 2.0 + fy_px_ * geometry_.height_m / from_camera.y()};
}

bool CameraModel::sees(const Vec2& in_robot, double margin_px) const noexcept {
  const auto at = pixel(in_robot);
  return at && at->column >= margin_px && at->column <= geometry_.width_px - margin_px &&
         at->row <= geometry_.height_px - margin_px;
}

}  // namespace galilean::robot
