#include "monitor/map/team_map.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/wire/topics.h"

namespace galilean::monitor {
namespace {

constexpr double kAlignEvery_s = 0.5;
constexpr double kFreshPose_s = 0.3;     ///< older than this a pose is no partner of a sighting
constexpr double kFloorStep_m = 0.05;    ///< standing still is no new evidence
constexpr double kMostSightRange_m = 4;  ///< beyond, the end of a sight line is too unsure
constexpr double kPoseVariance_m2 = 4e-4;

bool is_obstacle(const msg::Variable& variable) {
  return variable.type == msg::Variable_Constants::LOCATE && variable.valid &&
         variable.object_class == "obstacle" && variable.values.size() >= 2 &&
         std::isfinite(variable.values[0]) && std::isfinite(variable.values[1]);
}

/// What one robot saw, in another's odom frame.
msg::Sightings in_frame(msg::Sightings seen, const FrameEstimate& from, const FrameEstimate& to) {
  const auto carry_over = [&](auto& message) {
    const Vec2 there = to.to_odom(from.to_map(Vec2(message.x_m, message.y_m)));
    message.x_m = there.x();
    message.y_m = there.y();
  };
  carry_over(seen);
  seen.heading_rad = wrap_angle(seen.heading_rad + from.pose.heading_rad - to.pose.heading_rad);
  for (auto& item : seen.items) {
    // All ways alike, and rather too much: it only says what may be the same thing.
    const Vec2 here(item.x_m, item.y_m);
    const double own = item.variance_xx + item.variance_yy + from.covariance_at(here).trace();
    carry_over(item);
    const Vec2 there(item.x_m, item.y_m);
    item.variance_xx = item.variance_yy = own + to.covariance_at(there).trace();
    item.variance_xy = 0;
  }
  return seen;
}

void put(const Gaussian2& place, auto& message) {
  message.x_m = place.mean_m.x();
  message.y_m = place.mean_m.y();
  message.variance_xx = place.covariance_m2(0, 0);
  message.variance_xy = place.covariance_m2(0, 1);
  message.variance_yy = place.covariance_m2(1, 1);
}

}  // namespace

void TeamMap::note(const msg::RobotState& state, Time now) {
  if (!std::isfinite(state.x_m) || !std::isfinite(state.y_m) || !std::isfinite(state.heading_rad))
    return;
  Mapped& robot = robots_[state.robot];
  robot.in_odom = {{state.x_m, state.y_m}, state.heading_rad};
  robot.placed = true;
  robot.heard = robot.posed = now;
  const Vec2 in_map = frames_.of(state.robot).to_map(robot.in_odom.position_m);
  if ((in_map - robot.last_stood_m).norm() < kFloorStep_m) return;
  robot.last_stood_m = in_map;
  floor_.stood(in_map);
}

void TeamMap::note(const msg::Sightings& frame, Time now) {
  robots_[frame.robot].heard = now;
  const FrameEstimate& to_map = frames_.of(frame.robot);
  msg::Sightings things = frame;
  std::erase_if(things.items, [&](const msg::Sighting& sighting) {
    return sighting.object_class == "trash" &&
           object_map_.is_carried(to_map.to_map(Vec2(sighting.x_m, sighting.y_m)));
  });
  memories_[frame.robot].see(things, now);
  doubt_together(things, now);
  for (const auto& sighting : frame.items) {
    if (sighting.object_class == "robot") meet(frame.robot, sighting, now);
    if (sighting.range_m < kMostSightRange_m)
      floor_.looked(to_map.to_map(Vec2(frame.x_m, frame.y_m)),
                    to_map.to_map(Vec2(sighting.x_m, sighting.y_m)));
  }
}

void TeamMap::doubt_together(const msg::Sightings& things, Time now) {
  constexpr double kLongestPeriod_s = 0.5;
  const Time before = std::exchange(robots_[things.robot].last_frame, now);
  const double period_s = std::min(to_seconds(now - before), kLongestPeriod_s);
  const FrameEstimate& own = frames_.of(things.robot);
  for (auto& [robot, memory] : memories_)
    memory.doubt_unseen(robot == things.robot ? things : in_frame(things, own, frames_.of(robot)),
                        period_s);
}

void TeamMap::meet(const std::string& observer, const msg::Sighting& sighting, Time now) {
  ++sightings_of_robots_;
  for (const auto& [observed, robot] : robots_) {
    if (observed == observer || !robot.placed || to_seconds(now - robot.posed) > kFreshPose_s)
      continue;
    frames_.note({observer,
                  observed,
                  {sighting.x_m, sighting.y_m},
                  robot.in_odom.position_m,
                  sightings_of_robots_,
                  now});
  }
}

void TeamMap::note(const msg::Variables& variables, Time now) {
  Mapped& robot = robots_[variables.robot];
  robot.heard = now;
  robot.grasp.note(variables, now);
  for (const auto& variable : variables.items) {
    if (!is_obstacle(variable)) continue;
    const auto [touched, is_new] = robot.touched.try_emplace(variable.name, variable.updated);
    if (!is_new && std::exchange(touched->second, variable.updated) == variable.updated) continue;
    memories_[variables.robot].touch(variable, now);
    floor_.bumped(frames_.of(variables.robot).to_map(Vec2(variable.values[0], variable.values[1])));
  }
}

void TeamMap::note(const msg::Catalog& catalog, Time now) {
  Mapped& robot = robots_[catalog.robot];
  robot.heard = now;
  if (auto read = catalog_from_json(catalog.json)) robot.catalog = std::move(read).value();
  if (robot.program) robot.grasp.note(*robot.program, robot.catalog);
}

void TeamMap::note(const msg::Program& program, Time now) {
  Mapped& robot = robots_[program.robot];
  robot.heard = now;
  robot.program = program;
  robot.grasp.note(program, robot.catalog);
}

void TeamMap::update(Time now) {
  for (auto& [name, memory] : memories_) memory.fade(now);
  if (to_seconds(now - aligned_) >= kAlignEvery_s) {
    frames_.align(memories_, now);
    aligned_ = now;
  }
  object_map_.merge(memories_, frames_);
  std::vector<ObjectMap::Carrier> carriers;
  for (const auto& [name, robot] : robots_)
    if (robot.placed)
      carriers.push_back({name, frames_.of(name).to_map(robot.in_odom), robot.grasp.holds(now)});
  object_map_.carry(carriers, memories_, frames_, now);
}

msg::MapRobot TeamMap::robot_message(const std::string& name, const Mapped& robot, Time now) {
  const FrameEstimate& frame = frames_.of(name);
  const Pose2 pose = frame.to_map(robot.in_odom);
  msg::MapRobot message;
  message.name = name;
  put({pose.position_m,
       frame.covariance_at(robot.in_odom.position_m) + kPoseVariance_m2 * Mat2::Identity()},
      message);
  message.heading_rad = pose.heading_rad;
  message.age_s = static_cast<float>(to_seconds(now - robot.heard));
  message.silent = now - robot.heard > silent_after_;
  return message;
}

msg::ObjectMap TeamMap::objects(Time now, std::int64_t stamp_ns) {
  msg::ObjectMap message;
  message.stamp = wire::ros_time(stamp_ns);
  for (const auto& object : object_map_.objects()) {
    msg::MapObject& item = message.objects.emplace_back();
    item.id = static_cast<std::uint32_t>(object.id);
    item.object_class = object.object_class;
    put(object.place, item);
    item.certainty = static_cast<float>(object.certainty);
    item.decay_per_s = object.held_by.empty() ? 1 / static_cast<float>(RobotMemory::kMemory_s) : 0;
    item.last_seen = wire::ros_time(stamp_ns - (now - object.last_seen).count());
    item.seen_by = object.seen_by;
    item.held_by = object.held_by;
  }
  for (const auto& [name, robot] : robots_)
    if (robot.placed) message.robots.push_back(robot_message(name, robot, now));
  return message;
}

msg::TFMessage TeamMap::transforms(std::int64_t stamp_ns) {
  msg::TFMessage message;
  for (const auto& [name, robot] : robots_) {
    const Pose2& frame = frames_.of(name).pose;
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
