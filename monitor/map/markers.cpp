#include "monitor/map/markers.h"

#include <algorithm>
#include <cmath>

namespace galilean::monitor {
namespace {

enum MarkerType : std::int32_t { kCube = 1, kCylinder = 3, kText = 9 };
constexpr float kLeastOpaque = 0.15F;

struct Look {
  double diameter_m;
  double height_m;
  msg::ColorRGBA colour;
};

Look look_of(const std::string& object_class) {
  if (object_class == "trash") return {0.07, 0.12, {0.90F, 0.62F, 0.00F, 1}};
  if (object_class == "basket") return {0.30, 0.35, {0.00F, 0.45F, 0.70F, 1}};
  return {0.16, 0.30, {0.45F, 0.45F, 0.45F, 1}};
}

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

msg::Marker object_marker(const msg::ObjectMap& map, const msg::MapObject& object) {
  const Look look = look_of(object.object_class);
  auto result = marker(map, "objects", static_cast<std::int32_t>(object.id), kCylinder, object.x_m,
                       object.y_m, look.height_m / 2);
  result.scale = {look.diameter_m, look.diameter_m, look.height_m};
  result.color = look.colour;
  result.color.a = std::max(object.certainty, kLeastOpaque);
  return result;
}

msg::Marker body_marker(const msg::ObjectMap& map, const msg::MapRobot& robot, std::int32_t id) {
  auto result = marker(map, "robots", id, kCube, robot.x_m, robot.y_m, 0.15);
  result.pose.orientation.z = std::sin(robot.heading_rad / 2);
  result.pose.orientation.w = std::cos(robot.heading_rad / 2);
  result.scale = {0.43, 0.33, 0.30};
  result.color = {0.00F, 0.62F, 0.45F, robot.silent ? 0.3F : 1.0F};
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
  for (const auto& object : map.objects) result.markers.push_back(object_marker(map, object));
  std::int32_t id = 0;
  for (const auto& robot : map.robots) {
    result.markers.push_back(body_marker(map, robot, id));
    result.markers.push_back(name_marker(map, robot, id++));
  }
  return result;
}

}  // namespace galilean::monitor
