#include <cmath>

#include "core/wire/messages.h"
#include "core/wire/ros_time.h"
#include "monitor/map/team_map.h"

namespace galilean::monitor {
namespace {

constexpr double kPose_m2 = 1e-4;  ///< of a pose that is 0.1 s old

void put(const Gaussian2& place, auto& message) {
  message.x_m = place.mean_m.x();
  message.y_m = place.mean_m.y();
  message.variance_xx = place.covariance_m2(0, 0);
  message.variance_xy = place.covariance_m2(0, 1);
  message.variance_yy = place.covariance_m2(1, 1);
}

}  // namespace

msg::MapRobot TeamMap::robot_message(const std::string& name, Time now) const {
  msg::MapRobot message;
  message.name = name;
  const RobotPoses& poses = squads_.of(name).poses;
  Gaussian2 at = poses.position(name);
  at.covariance_m2 += kPose_m2 * Mat2::Identity();
  put(at, message);
  message.heading_rad = poses.pose(name).heading_rad;
  const Time heard = heard_.at(name).at;
  message.age_s = static_cast<float>(to_seconds(now - heard));
  message.silent = now - heard > silent_after_;
  return message;
}

void TeamMap::put_landmarks(msg::ObjectMap& message, Time now, std::int64_t stamp_ns) const {
  for (const auto& landmark : told_) {
    msg::MapObject& item = message.objects.emplace_back();
    item.id = static_cast<std::uint32_t>(landmark.id);
    item.object_class = landmark.object_class;
    put(landmark.place, item);
    item.certainty = static_cast<float>(landmark.certainty);
    item.decay_per_s = 1 / static_cast<float>(Landmark::kMemory_s);
    item.last_seen = wire::ros_time(stamp_ns - (now - landmark.last_seen).count());
    item.seen_by = latest_first(landmark.seen_by);
  }
}

void TeamMap::put_loads(msg::ObjectMap& message) const {
  for (const auto& [robot, load] : carried_.all()) {
    msg::MapObject& item = message.objects.emplace_back();
    item.id = static_cast<std::uint32_t>(load.id);
    item.object_class = "trash";
    put(carried_.place(robot), item);
    item.certainty = 1;
    item.last_seen = message.stamp;
    item.seen_by = load.seen_by;
    item.held_by = robot;
  }
}

msg::ObjectMap TeamMap::objects(Time now, std::int64_t stamp_ns) const {
  msg::ObjectMap message;
  message.stamp = wire::ros_time(stamp_ns);
  put_landmarks(message, now, stamp_ns);
  put_loads(message);
  for (const auto& [name, squad] : squads_.robots())
    message.robots.push_back(robot_message(name, now));
  return message;
}

msg::TFMessage TeamMap::transforms(std::int64_t stamp_ns) const {
  msg::TFMessage message;
  for (const auto& [name, squad] : squads_.robots()) {
    const Pose2 frame = squad->poses.frame(name);
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
