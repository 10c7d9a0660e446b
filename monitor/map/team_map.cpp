#include "monitor/map/team_map.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/wire/topics.h"
#include "monitor/map/meetings.h"

namespace galilean::monitor {
namespace {

constexpr double kAlignEvery_s = 0.5;
constexpr double kFloorStep_m = 0.05;  ///< standing still is no new evidence
constexpr double kFloorTurn_rad = 0.1;
constexpr double kMostSightRange_m = 4;  ///< beyond, the end of a sight line is too unsure
constexpr double kTouchDeviation_m = 0.05;
constexpr double kVague_m = 0.6;
constexpr double kPose_m2 = 1e-4;  ///< of a pose that is 0.1 s old

bool is_obstacle(const msg::Variable& variable) {
  return variable.type == msg::Variable_Constants::LOCATE && variable.valid &&
         variable.object_class == "obstacle" && variable.values.size() >= 2 &&
         std::isfinite(variable.values[0]) && std::isfinite(variable.values[1]);
}

/// Seen from far away, it may stand anywhere within a metre: that is no place to tell.
bool is_vague(const Gaussian2& place) {
  return place.covariance_m2.trace() > kVague_m * kVague_m;
}

Vec2 in_map(const Pose2& frame, const Vec2& in_odom_m) {
  return frame.position_m + rotated(in_odom_m, frame.heading_rad);
}

void put(const Gaussian2& place, auto& message) {
  message.x_m = place.mean_m.x();
  message.y_m = place.mean_m.y();
  message.variance_xx = place.covariance_m2(0, 0);
  message.variance_xy = place.covariance_m2(0, 1);
  message.variance_yy = place.covariance_m2(1, 1);
}

}  // namespace

bool TeamMap::move(const std::string& robot, const Pose2& in_odom, Time now) {
  if (!in_odom.position_m.allFinite() || !std::isfinite(in_odom.heading_rad)) return false;
  if (poses_.knows(robot))
    things_.blur_around(robot, std::max(0.0, to_seconds(now - poses_.moved(robot))));
  Heard& heard = heard_[robot];
  poses_.move(robot, in_odom, heard.senses.touches(now), now);
  heard.at = now;
  return true;
}

void TeamMap::note(const msg::RobotState& state, Time now) {
  if (!move(state.robot, {{state.x_m, state.y_m}, state.heading_rad}, now)) return;
  const Vec2 at_m = poses_.pose(state.robot).position_m;
  Heard& robot = heard_[state.robot];
  robot.senses.note(state);
  if ((at_m - robot.last_stood_m).norm() < kFloorStep_m) return;
  robot.last_stood_m = at_m;
  floor_.stood(at_m);
}

void TeamMap::note(const msg::Sightings& frame, Time now) {
  if (!move(frame.robot, {{frame.x_m, frame.y_m}, frame.heading_rad}, now)) return;
  const Pose2 to_map = poses_.frame(frame.robot);
  msg::Sightings things = frame;
  std::erase_if(things.items, [&](const msg::Sighting& sighting) {
    return sighting.object_class == "trash" &&
           carried_.is_carried(in_map(to_map, {sighting.x_m, sighting.y_m}), poses_);
  });
  orientation_.look(things, now);
  things_.see(things, now);
  note_meetings(frame, poses_, joint_, now);
  look(frame);
}

void TeamMap::look(const msg::Sightings& frame) {
  const Pose2 pose = poses_.pose(frame.robot), to_map = poses_.frame(frame.robot);
  Pose2& last = heard_[frame.robot].last_looked;
  if ((pose.position_m - last.position_m).norm() < kFloorStep_m &&
      std::abs(wrap_angle(pose.heading_rad - last.heading_rad)) < kFloorTurn_rad)
    return;
  last = pose;
  Floor::View view{pose.position_m, pose.heading_rad, frame.view_angle_rad, {}};
  for (const auto& sighting : frame.items)
    if (sighting.range_m < kMostSightRange_m)
      view.seen_m.push_back(in_map(to_map, {sighting.x_m, sighting.y_m}));
  floor_.looked(view);
}

void TeamMap::note(const msg::Variables& variables, Time now) {
  Heard& robot = heard_[variables.robot];
  robot.at = now;
  robot.senses.note(variables, now);
  if (!poses_.knows(variables.robot)) return;
  for (const auto& variable : variables.items) {
    if (!is_obstacle(variable)) continue;
    const auto [touched, is_new] = robot.touched.try_emplace(variable.name, variable.updated);
    if (is_new || std::exchange(touched->second, variable.updated) != variable.updated)
      touch(variables.robot, variable, now);
  }
}

void TeamMap::touch(const std::string& robot, const msg::Variable& obstacle, Time now) {
  const Vec2 at_m = in_map(poses_.frame(robot), {obstacle.values[0], obstacle.values[1]});
  const Pose2 pose = poses_.pose(robot);
  const Gaussian2 from_robot{rotated(at_m - pose.position_m, -pose.heading_rad),
                             kTouchDeviation_m * kTouchDeviation_m * Mat2::Identity()};
  things_.note("obstacle", robot, from_robot, obstacle.certainty, now);
  floor_.bumped(at_m);
}

void TeamMap::note(const msg::Catalog& catalog, Time now) {
  Heard& robot = heard_[catalog.robot];
  robot.at = now;
  if (auto read = catalog_from_json(catalog.json)) robot.catalog = std::move(read).value();
  if (robot.program) robot.senses.note(*robot.program, robot.catalog);
}

void TeamMap::note(const msg::Program& program, Time now) {
  Heard& robot = heard_[program.robot];
  robot.at = now;
  robot.program = program;
  robot.senses.note(program, robot.catalog);
}

void TeamMap::update(Time now) {
  things_.fade(now);
  if (to_seconds(now - aligned_) >= kAlignEvery_s) {
    same_things_.align(now);
    aligned_ = now;
  }
  same_things_.unite_neighbours();
  for (const auto& [name, robot] : poses_.all()) {
    things_.clear_under(name);
    carried_.note(name, heard_[name].senses.holds(now), poses_, things_, now);
  }
}

msg::MapRobot TeamMap::robot_message(const std::string& name, Time now) const {
  msg::MapRobot message;
  message.name = name;
  Gaussian2 at = poses_.position(name);
  at.covariance_m2 += kPose_m2 * Mat2::Identity();
  put(at, message);
  message.heading_rad = poses_.pose(name).heading_rad;
  const Time heard = heard_.at(name).at;
  message.age_s = static_cast<float>(to_seconds(now - heard));
  message.silent = now - heard > silent_after_;
  return message;
}

void TeamMap::put_things(msg::ObjectMap& message, Time now, std::int64_t stamp_ns) const {
  for (const auto& thing : things_.all()) {
    if (!thing.told() || is_vague(things_.place(thing)) || things_.may_be_told_twice(thing))
      continue;
    msg::MapObject& item = message.objects.emplace_back();
    item.id = static_cast<std::uint32_t>(thing.id);
    item.object_class = thing.object_class;
    put(things_.place(thing), item);
    item.certainty = static_cast<float>(thing.certainty);
    item.decay_per_s = 1 / static_cast<float>(Thing::kMemory_s);
    item.last_seen = wire::ros_time(stamp_ns - (now - thing.last_seen).count());
    item.seen_by = thing.observers();
  }
}

void TeamMap::put_loads(msg::ObjectMap& message) const {
  for (const auto& [robot, load] : carried_.all()) {
    msg::MapObject& item = message.objects.emplace_back();
    item.id = static_cast<std::uint32_t>(load.id);
    item.object_class = "trash";
    put(Carried::place(robot, poses_), item);
    item.certainty = 1;
    item.last_seen = message.stamp;
    item.seen_by = load.seen_by;
    item.held_by = robot;
  }
}

msg::ObjectMap TeamMap::objects(Time now, std::int64_t stamp_ns) const {
  msg::ObjectMap message;
  message.stamp = wire::ros_time(stamp_ns);
  put_things(message, now, stamp_ns);
  put_loads(message);
  for (const auto& [name, robot] : poses_.all()) message.robots.push_back(robot_message(name, now));
  return message;
}

msg::TFMessage TeamMap::transforms(std::int64_t stamp_ns) const {
  msg::TFMessage message;
  for (const auto& [name, robot] : poses_.all()) {
    const Pose2 frame = poses_.frame(name);
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
