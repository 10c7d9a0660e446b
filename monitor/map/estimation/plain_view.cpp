#include "monitor/map/estimation/plain_view.h"

#include <algorithm>
#include <cmath>

namespace galilean::monitor {
namespace {

constexpr double kPlainViewFrom_m = 0.6;
constexpr double kPictureEdge_rad = 0.10;
constexpr double kHides_rad = 0.15;

bool is_hidden(const msg::Sightings& frame, double azimuth_rad, double range_m) {
  return std::ranges::any_of(frame.items, [&](const auto& other) {
    return other.range_m < range_m &&
           std::abs(wrap_angle(other.azimuth_rad - azimuth_rad)) < kHides_rad;
  });
}

}  // namespace

bool in_plain_view(const msg::Sightings& frame, const Vec2& from_robot_m) {
  const double range_m = from_robot_m.norm();
  if (range_m <= kPlainViewFrom_m || range_m >= kPlainViewTo_m) return false;
  const double azimuth_rad = std::atan2(from_robot_m.y(), from_robot_m.x());
  return std::abs(azimuth_rad) < frame.view_angle_rad / 2 - kPictureEdge_rad &&
         !is_hidden(frame, azimuth_rad, range_m);
}

}  // namespace galilean::monitor
