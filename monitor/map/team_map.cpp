// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/map/team_map.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "monitor/map/estimation/frames.h"
#include "monitor/map/estimation/mutual_observations.h"
#include "monitor/map/estimation/visible_area.h"
#include "monitor/map/groups/share_landmarks.h"
#include "monitor/map/map_messages.h"

namespace galilean::monitor {
namespace {

constexpr double kAlignEvery_s = 0.5;
constexpr double kTouchDeviation_m = 0.05;
/// An odometer that tells of more than this is broken.
constexpr double kFarthestOdometer_m = 1e6;
constexpr double kMostTurned_rad = 1e6;
/// So many objects of a frame are taken in, which is what a robot tells at most. Whatever a frame
/// costs grows with this.
constexpr std::size_t kMostSightings = 96;

/// Numbers that are not finite fail these comparisons.
bool is_plausible_odometry(const Pose2& in_odom) {
  return std::abs(in_odom.position_m.x()) <= kFarthestOdometer_m &&
         std::abs(in_odom.position_m.y()) <= kFarthestOdometer_m &&
         std::abs(in_odom.heading_rad) <= kMostTurned_rad;
}

}  // namespace

bool TeamMap::predict(const std::string& robot, const Pose2& in_odom, Time now) {
  if (!is_plausible_odometry(in_odom)) return false;
  RobotGroup& group = groups_.join(robot, in_odom);
  if (group.poses.contains(robot))
    group.landmarks.inflate_near(
        robot, std::max(0.0, to_seconds(now - group.poses.last_predicted(robot))));
  group.poses.predict(robot, in_odom, reports_.is_touching(robot, now), now);
  reports_.hear(robot, now);
  return true;
}

void TeamMap::add(const msg::RobotState& state, Time now) {
  if (!predict(state.robot, {{state.x_m, state.y_m}, state.heading_rad}, now)) return;
  reports_.add(state);
  occupancy_.add_robot(state.robot, groups_.of(state.robot).poses, now);
}

void TeamMap::add(const msg::Sightings& frame, Time now) {
  if (frame.items.size() > kMostSightings) {
    msg::Sightings shorter = frame;
    shorter.items.resize(kMostSightings);
    return add(shorter, now);
  }
  if (!predict(frame.robot, {{frame.x_m, frame.y_m}, frame.heading_rad}, now)) return;
  RobotGroup& group = groups_.of(frame.robot);
  const msg::Sightings on_floor = without_carried(frame);
  group.heading_recovery.update(on_floor, now);
  const Viewpoint from = group.landmarks.update(on_floor, now);
  if (std::ranges::find(frame.items, "robot", &msg::Sighting::object_class) != frame.items.end())
    correct_by_mutual_observations(frame, group.poses, group.joint, robots_of_others(group), now);
  for (RobotGroup* other : groups_.others_near(group, from.pose.position_m, kVisibleTo_m))
    other->landmarks.penalize_unseen(on_floor, from);
  occupancy_.add_frame(frame, group.poses);
}

// An object in a gripper moves with its robot, so it is no landmark.
msg::Sightings TeamMap::without_carried(const msg::Sightings& frame) const {
  const Pose2 odom = groups_.of(frame.robot).poses.odom_frame(frame.robot);
  const auto grippers_m = carried_.grippers_m();
  msg::Sightings result = frame;
  std::erase_if(result.items, [&](const msg::Sighting& sighting) {
    return sighting.object_class == "trash" &&
           CarriedObjects::is_carried(in_map(odom, Vec2(sighting.x_m, sighting.y_m)), grippers_m);
  });
  return result;
}

std::vector<Gaussian2> TeamMap::robots_of_others(const RobotGroup& group) const {
  std::vector<Gaussian2> others;
  for (const auto& [name, its_group] : groups_.robots())
    if (its_group != &group) others.push_back(its_group->poses.position(name));
  return others;
}

std::vector<Gaussian2> TeamMap::robots_but(const std::string& robot) const {
  std::vector<Gaussian2> others;
  for (const auto& [name, group] : groups_.robots())
    if (name != robot) others.push_back(group->poses.position(name));
  return others;
}

void TeamMap::add(const msg::Variables& variables, Time now) {
  reports_.add(variables, now);
  if (!groups_.contains(variables.robot)) return;
  for (const auto& obstacle : reports_.take_new_obstacles(variables))
    add_obstacle(variables.robot, obstacle, now);
}

void TeamMap::add_obstacle(const std::string& robot, const msg::Variable& obstacle, Time now) {
  RobotGroup& group = groups_.of(robot);
  const Vec2 at_m =
      in_map(group.poses.odom_frame(robot), Vec2(obstacle.values[0], obstacle.values[1]));
  const Gaussian2 position{in_robot(group.poses.pose(robot), at_m),
                           kTouchDeviation_m * kTouchDeviation_m * Mat2::Identity()};
  group.landmarks.add_contact("obstacle", robot, position, obstacle.certainty, now);
  occupancy_.add_touch(robot, obstacle, group.poses, robots_but(robot), now);
}

void TeamMap::forget(const std::string& robot) {
  reports_.forget(robot);
  occupancy_.forget(robot);
  carried_.forget(robot);
  if (!groups_.contains(robot)) return;
  const auto dissolved = groups_.leave(robot);
  if (!dissolved) return;
  localizer_.forget(*dissolved);
  // The next update still reads what was published last, with the groups that it came from.
  for (auto& landmark : published_)
    std::erase_if(landmark.sources,
                  [&](const auto& source) { return source.group == dissolved.get(); });
  std::erase_if(published_, [](const auto& landmark) { return landmark.sources.empty(); });
}

void TeamMap::update(Time now) {
  for (const auto& group : groups_.all()) group->landmarks.decay(now);
  align(now);
  for (const auto& group : groups_.all()) {
    group->merger.merge_neighbours();
    group->extent_m = group->landmarks.extent_m();
  }
  for (const auto& [name, group] : groups_.robots()) {
    clear_footprint(name);
    carried_.update(name, reports_.is_holding(name, now), published_, now);
  }
  auto landmarks = landmarks_by_group(groups_);
  const auto pairs = duplicate_pairs(landmarks);
  share_landmarks(landmarks, pairs);
  published_ = merged(std::move(landmarks), pairs);
}

// Alignment costs most of an update. Therefore only one group is aligned at a time: the one that
// was aligned least recently.
void TeamMap::align(Time now) {
  if (groups_.all().empty()) return;
  const auto last_aligned = [](const auto& group) { return group->last_aligned; };
  RobotGroup& group = **std::ranges::min_element(groups_.all(), {}, last_aligned);
  if (to_seconds(now - group.last_aligned) < kAlignEvery_s) return;
  group.last_aligned = now;
  group.merger.align(
      now, group.is_localized ? known_to_others(group, published_) : std::vector<LabelledPoint>{});
  localizer_.localize_next(published_);
}

void TeamMap::clear_footprint(const std::string& robot) {
  RobotGroup& group = groups_.of(robot);
  group.landmarks.clear_footprint(robot);
  const Gaussian2 at = group.poses.position(robot);
  for (RobotGroup* other : groups_.others_near(group, at.mean_m, LandmarkContacts::kFootprint_m))
    other->landmarks.clear_footprint(at);
}

msg::ObjectMap TeamMap::objects(Time now, std::int64_t stamp_ns) const {
  return objects_message({groups_, published_, carried_, reports_}, silent_after_, now, stamp_ns);
}

msg::TFMessage TeamMap::transforms(std::int64_t stamp_ns) const {
  return transforms_message(groups_, stamp_ns);
}

}  // namespace galilean::monitor
