// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/map/estimation/visible_area.h"

#include <algorithm>
#include <cmath>

namespace galilean::monitor {
namespace {

constexpr double kVisibleFrom_m = 0.6;
constexpr double kPictureEdge_rad = 0.10;
constexpr double kOcclusion_rad = 0.15;  ///< an object hides others within this of its azimuth

bool is_occluded(const msg::Sightings& frame, double azimuth_rad, double range_m) {
  return std::ranges::any_of(frame.items, [&](const auto& other) {
    return other.range_m < range_m &&
           std::abs(wrap_angle(other.azimuth_rad - azimuth_rad)) < kOcclusion_rad;
  });
}

}  // namespace

bool in_visible_area(const msg::Sightings& frame, const Vec2& in_robot_m) {
  const double range_m = in_robot_m.norm();
  if (range_m <= kVisibleFrom_m || range_m >= kVisibleTo_m) return false;
  const double azimuth_rad = std::atan2(in_robot_m.y(), in_robot_m.x());
  return std::abs(azimuth_rad) < frame.view_angle_rad / 2 - kPictureEdge_rad &&
         !is_occluded(frame, azimuth_rad, range_m);
}

}  // namespace galilean::monitor
