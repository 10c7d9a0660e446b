// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/map/export/markers.h"

#include <algorithm>
#include <cmath>

#include "monitor/map/export/appearance.h"

namespace galilean::monitor {
namespace {

enum MarkerType : std::int32_t { kCube = 1, kCylinder = 3, kText = 9 };
constexpr double kEllipseHeight_m = 0.01;
constexpr double kLeastVariance_m2 = 1e-6;  ///< because viewers reject an ellipse without width

msg::Marker marker(const msg::ObjectMap& map, const char* space, std::int32_t id, MarkerType type,
                   double x_m, double y_m, double z_m) {
  msg::Marker result;
  result.header = {map.stamp, "map"};
  result.ns = space;
  result.id = id;
  result.type = type;
  result.pose.position = {x_m, y_m, z_m};
  result.pose.orientation.w = 1;
  result.lifetime.nanosec = 600'000'000;
  return result;
}

void turn(msg::Marker& marker, double by_rad) {
  marker.pose.orientation.z = std::sin(by_rad / 2);
  marker.pose.orientation.w = std::cos(by_rad / 2);
}

/// Returns the 95 % ellipse of an object or a robot as a flat, stretched cylinder.
msg::Marker ellipse_marker(const msg::ObjectMap& map, const char* space, std::int32_t id,
                           const auto& at) {
  auto result = marker(map, space, id, kCylinder, at.x_m, at.y_m, kEllipseHeight_m / 2);
  const double mean_m2 = (at.variance_xx + at.variance_yy) / 2;
  const double spread_m2 = std::hypot((at.variance_xx - at.variance_yy) / 2, at.variance_xy);
  turn(result, std::atan2(2 * at.variance_xy, at.variance_xx - at.variance_yy) / 2);
  const auto axis_m = [](double variance_m2) {
    return 2 * kEllipseDeviations * std::sqrt(std::max(variance_m2, kLeastVariance_m2));
  };
  result.scale = {axis_m(mean_m2 + spread_m2), axis_m(mean_m2 - spread_m2), kEllipseHeight_m};
  result.color = {0.8F, 0.8F, 0.8F, 0.35F};
  return result;
}

msg::Marker object_marker(const msg::ObjectMap& map, const msg::MapObject& object) {
  const Appearance appearance = appearance_of(object.object_class);
  auto result = marker(map, "objects", static_cast<std::int32_t>(object.id), kCylinder, object.x_m,
                       object.y_m, appearance.height_m / 2);
  result.scale = {appearance.diameter_m, appearance.diameter_m, appearance.height_m};
  result.color = {appearance.red, appearance.green, appearance.blue,
                  std::max(object.certainty, kLeastOpacity)};
  return result;
}

msg::Marker body_marker(const msg::ObjectMap& map, const msg::MapRobot& robot, std::int32_t id) {
  auto result = marker(map, "robots", id, kCube, robot.x_m, robot.y_m, Body::kHeight_m / 2);
  turn(result, robot.heading_rad);
  result.scale = {Body::kLength_m, Body::kWidth_m, Body::kHeight_m};
  result.color = {Body::kRed, Body::kGreen, Body::kBlue,
                  robot.silent ? Body::kSilentOpacity : 1.0F};
  return result;
}

msg::Marker name_marker(const msg::ObjectMap& map, const msg::MapRobot& robot, std::int32_t id) {
  auto result = marker(map, "names", id, kText, robot.x_m, robot.y_m, 0.5);
  result.scale.z = 0.15;
  result.color = {1, 1, 1, 1};
  result.text = robot.name;
  return result;
}

}  // namespace

msg::MarkerArray markers(const msg::ObjectMap& map) {
  msg::MarkerArray result;
  for (const auto& object : map.objects) {
    const auto id = static_cast<std::int32_t>(object.id);
    result.markers.push_back(object_marker(map, object));
    result.markers.push_back(ellipse_marker(map, "object_ellipses", id, object));
  }
  std::int32_t id = 0;
  for (const auto& robot : map.robots) {
    result.markers.push_back(ellipse_marker(map, "robot_ellipses", id, robot));
    result.markers.push_back(body_marker(map, robot, id));
    result.markers.push_back(name_marker(map, robot, id++));
  }
  return result;
}

}  // namespace galilean::monitor
