// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/map/map_messages.h"

#include <cmath>

#include "core/wire/messages.h"
#include "core/wire/ros_time.h"

namespace galilean::monitor {
namespace {

/// The variance that is added to a robot's, because its pose is up to 0.1 s old when published.
constexpr double kPoseAge_m2 = 1e-4;

void put(const Gaussian2& position, auto& message) {
  message.x_m = position.mean_m.x();
  message.y_m = position.mean_m.y();
  message.variance_xx = position.covariance_m2(0, 0);
  message.variance_xy = position.covariance_m2(0, 1);
  message.variance_yy = position.covariance_m2(1, 1);
}

msg::MapRobot robot_message(const MapContents& map, const std::string& name, Duration silent_after,
                            Time now) {
  msg::MapRobot message;
  message.name = name;
  const RobotPoses& poses = map.groups.of(name).poses;
  Gaussian2 at = poses.position(name);
  at.covariance_m2 += kPoseAge_m2 * Mat2::Identity();
  put(at, message);
  message.heading_rad = poses.pose(name).heading_rad;
  const Duration age = now - map.reports.last_heard(name);
  message.age_s = static_cast<float>(to_seconds(age));
  message.silent = age > silent_after;
  return message;
}

msg::MapObject landmark_message(const PublishedLandmark& landmark, Time now,
                                std::int64_t stamp_ns) {
  msg::MapObject message;
  message.id = static_cast<std::uint32_t>(landmark.id);
  message.object_class = landmark.object_class;
  put(landmark.position, message);
  message.certainty = static_cast<float>(landmark.certainty);
  message.decay_per_s = 1 / static_cast<float>(Landmark::kMemory_s);
  message.last_seen = wire::ros_time(stamp_ns - (now - landmark.last_seen).count());
  message.seen_by = latest_first(landmark.seen_by);
  return message;
}

msg::MapObject load_message(const CarriedObjects& carried, const std::string& robot,
                            const CarriedObjects::Load& load, const msg::Time& stamp) {
  msg::MapObject message;
  message.id = static_cast<std::uint32_t>(load.id);
  message.object_class = "trash";
  put(carried.position(robot), message);
  message.certainty = 1;
  message.last_seen = stamp;
  message.seen_by = load.seen_by;
  message.held_by = robot;
  return message;
}

}  // namespace

msg::ObjectMap objects_message(const MapContents& map, Duration silent_after, Time now,
                               std::int64_t stamp_ns) {
  msg::ObjectMap message;
  message.stamp = wire::ros_time(stamp_ns);
  for (const auto& landmark : map.landmarks)
    message.objects.push_back(landmark_message(landmark, now, stamp_ns));
  for (const auto& [robot, load] : map.carried.all())
    message.objects.push_back(load_message(map.carried, robot, load, message.stamp));
  for (const auto& [name, group] : map.groups.robots())
    message.robots.push_back(robot_message(map, name, silent_after, now));
  return message;
}

msg::TFMessage transforms_message(const RobotGroups& groups, std::int64_t stamp_ns) {
  msg::TFMessage message;
  for (const auto& [name, group] : groups.robots()) {
    const Pose2 frame = group->poses.odom_frame(name);
    msg::TransformStamped& item = message.transforms.emplace_back();
    item.header = {wire::ros_time(stamp_ns), "map"};
    item.child_frame_id = name + "/odom";
    item.transform.translation = {frame.position_m.x(), frame.position_m.y(), 0};
    item.transform.rotation = {0, 0, std::sin(frame.heading_rad / 2),
                               std::cos(frame.heading_rad / 2)};
  }
  return message;
}

}  // namespace galilean::monitor
