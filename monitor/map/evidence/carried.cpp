#include "monitor/map/evidence/carried.h"

#include <algorithm>
#include <optional>

namespace galilean::monitor {
namespace {

constexpr double kGripperAhead_m = 0.27;
constexpr double kReach_m = 0.25;  ///< from the gripper to what it may have picked up
constexpr double kCarriedWithin_m = 0.25;
constexpr double kBasketReach_m = 0.65;  ///< what is put down nearer than this is in the basket
constexpr double kInGripper_m = 0.03;

const Gaussian2 kInGripper{{kGripperAhead_m, 0}, kInGripper_m* kInGripper_m* Mat2::Identity()};

/// As it is told; by itself if it is not.
ToldThing known_as(const ToldThing& landmark, const std::vector<ToldThing>& told) {
  const ToldThing::Note& note = landmark.notes.front();
  const auto found = std::ranges::find_if(
      told, [&](const ToldThing& other) { return other.has(*note.squad, note.id); });
  return found == told.end() ? landmark : *found;
}

/// The nearest piece of trash that any squad noted there.
std::optional<ToldThing> trash_at(const Vec2& at_m, double within_m, const Squads& squads) {
  std::optional<ToldThing> nearest;
  for (const auto& squad : squads.all())
    for (const auto& landmark : squad->landmarks.all()) {
      const double away_m = (squad->landmarks.place(landmark).mean_m - at_m).norm();
      if (landmark.object_class != "trash" || away_m >= within_m) continue;
      within_m = away_m;
      nearest.emplace();
      nearest->id = landmark.id;
      nearest->seen_by = landmark.seen_by;
      nearest->notes = {{squad.get(), landmark.id}};
    }
  return nearest;
}

bool basket_at(const Vec2& at_m, const LandmarkMap& landmarks) {
  return std::ranges::any_of(landmarks.all(), [&](const Landmark& landmark) {
    return landmark.object_class == "basket" && landmark.is_publishable() &&
           (landmarks.place(landmark).mean_m - at_m).norm() < kBasketReach_m;
  });
}

Vec2 gripper_m(const Pose2& robot) {
  return robot.position_m + kGripperAhead_m * unit_vector(robot.heading_rad);
}

}  // namespace

Gaussian2 Carried::place(const std::string& robot) const {
  const RobotPoses& poses = squads_.of(robot).poses;
  return {gripper_m(poses.pose(robot)),
          poses.position(robot).covariance_m2 + kInGripper.covariance_m2};
}

void Carried::note(const std::string& robot, bool holds, const std::vector<ToldThing>& told,
                   Time now) {
  const bool held = loads_.contains(robot);
  if (holds && !held) pick_up(robot, told);
  if (!holds && held) put_down(robot, now);
}

void Carried::pick_up(const std::string& robot, const std::vector<ToldThing>& told) {
  const auto nearest = trash_at(place(robot).mean_m, kReach_m, squads_);
  if (!nearest) {
    loads_[robot] = {squads_.next_id(), {robot}, false};
    return;
  }
  const ToldThing landmark = known_as(*nearest, told);
  loads_[robot] = {landmark.id, latest_first(landmark.seen_by), true};
  for (const auto& note : landmark.notes) note.squad->landmarks.remove(note.id);
}

void Carried::put_down(const std::string& robot, Time now) {
  const Load load = loads_.extract(robot).mapped();
  const Vec2 at_m = place(robot).mean_m;
  const bool in_basket = std::ranges::any_of(
      squads_.all(), [&](const auto& squad) { return basket_at(at_m, squad->landmarks); });
  if (!in_basket && load.was_known)
    squads_.of(robot).landmarks.add_contact("trash", robot, kInGripper, 1, now, load.id);
}

std::vector<Vec2> Carried::grippers_m() const {
  std::vector<Vec2> all;
  for (const auto& [robot, load] : loads_)
    all.push_back(gripper_m(squads_.of(robot).poses.pose(robot)));
  return all;
}

bool Carried::is_carried(const Vec2& in_map_m, const std::vector<Vec2>& grippers_m) {
  return std::ranges::any_of(grippers_m, [&](const Vec2& gripper) {
    return (gripper - in_map_m).norm() < kCarriedWithin_m;
  });
}

}  // namespace galilean::monitor
