// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/map/evidence/carried_objects.h"

#include <algorithm>
#include <optional>

namespace galilean::monitor {
namespace {

constexpr double kGripperAhead_m = 0.27;
constexpr double kReach_m = 0.25;  ///< from the gripper to an object that it may have picked up
constexpr double kCarriedWithin_m = 0.25;
constexpr double kBasketReach_m = 0.65;  ///< an object put down nearer than this is in a basket
constexpr double kInGripper_m = 0.03;

/// The position of a held object in the robot frame.
const Gaussian2 kInGripper{{kGripperAhead_m, 0}, kInGripper_m* kInGripper_m* Mat2::Identity()};

/// Returns the published landmark that has `own`, a landmark of one group, as a source. Returns
/// `own` if there is none.
PublishedLandmark published_as(const PublishedLandmark& own, const PublishedLandmarks& published) {
  const PublishedLandmark::Source& source = own.sources.front();
  const auto found = std::ranges::find_if(published, [&](const PublishedLandmark& other) {
    return other.has(*source.group, source.id);
  });
  return found == published.end() ? own : *found;
}

/// Returns the piece of trash in any group's map that is nearest to `at_m` and within `within_m`.
std::optional<PublishedLandmark> trash_at(const Vec2& at_m, double within_m,
                                          const RobotGroups& groups) {
  std::optional<PublishedLandmark> nearest;
  for (const auto& group : groups.all())
    for (const auto& landmark : group->landmarks.all()) {
      const double away_m = (group->landmarks.position(landmark).mean_m - at_m).norm();
      if (landmark.object_class != "trash" || away_m >= within_m) continue;
      within_m = away_m;
      nearest.emplace();
      nearest->id = landmark.id;
      nearest->seen_by = landmark.seen_by;
      nearest->sources = {{group.get(), landmark.id}};
    }
  return nearest;
}

bool basket_at(const Vec2& at_m, const LandmarkMap& landmarks) {
  return std::ranges::any_of(landmarks.all(), [&](const Landmark& landmark) {
    return landmark.object_class == "basket" && landmark.is_publishable() &&
           (landmarks.position(landmark).mean_m - at_m).norm() < kBasketReach_m;
  });
}

Vec2 gripper_m(const Pose2& robot) {
  return robot.position_m + kGripperAhead_m * unit_vector(robot.heading_rad);
}

}  // namespace

Gaussian2 CarriedObjects::position(const std::string& robot) const {
  const RobotPoses& poses = groups_.of(robot).poses;
  return {gripper_m(poses.pose(robot)),
          poses.position(robot).covariance_m2 + kInGripper.covariance_m2};
}

void CarriedObjects::update(const std::string& robot, bool holds,
                            const PublishedLandmarks& published, Time now) {
  const bool held = loads_.contains(robot);
  if (holds && !held) pick_up(robot, published);
  if (!holds && held) put_down(robot, now);
}

void CarriedObjects::pick_up(const std::string& robot, const PublishedLandmarks& published) {
  const auto nearest = trash_at(position(robot).mean_m, kReach_m, groups_);
  if (!nearest) {
    loads_[robot] = {groups_.next_id(), {robot}, false};
    return;
  }
  const PublishedLandmark landmark = published_as(*nearest, published);
  loads_[robot] = {landmark.id, latest_first(landmark.seen_by), true};
  for (const auto& source : landmark.sources) source.group->landmarks.remove(source.id);
}

void CarriedObjects::put_down(const std::string& robot, Time now) {
  const Load load = loads_.extract(robot).mapped();
  const Vec2 at_m = position(robot).mean_m;
  const bool in_basket = std::ranges::any_of(
      groups_.all(), [&](const auto& group) { return basket_at(at_m, group->landmarks); });
  if (!in_basket && load.was_known)
    groups_.of(robot).landmarks.add_contact("trash", robot, kInGripper, 1, now, load.id);
}

std::vector<Vec2> CarriedObjects::grippers_m() const {
  std::vector<Vec2> all;
  for (const auto& [robot, load] : loads_)
    all.push_back(gripper_m(groups_.of(robot).poses.pose(robot)));
  return all;
}

bool CarriedObjects::is_carried(const Vec2& in_map_m, const std::vector<Vec2>& grippers_m) {
  return std::ranges::any_of(grippers_m, [&](const Vec2& gripper) {
    return (gripper - in_map_m).norm() < kCarriedWithin_m;
  });
}

}  // namespace galilean::monitor
