#include "monitor/map/object_map.h"

#include <algorithm>
#include <utility>

namespace galilean::monitor {
namespace {

constexpr double kGripperAhead_m = 0.30;
constexpr double kReach_m = 0.40;  ///< from the gripper to what it may have picked up
constexpr double kCarriedWithin_m = 0.25;
constexpr double kBasketReach_m = 0.60;  ///< what is put down nearer than this is in the basket

Vec2 gripper_of(const Pose2& robot) {
  return robot.position_m + kGripperAhead_m * unit_vector(robot.heading_rad);
}

bool saw(const MapObject& object, const std::string& robot) {
  return std::ranges::find(object.seen_by, robot) != object.seen_by.end();
}

/// Far outside any gate: spares the exact distance.
bool is_far(const Gaussian2& a, const Gaussian2& b) {
  const double variance = a.covariance_m2.trace() + b.covariance_m2.trace();
  return (a.mean_m - b.mean_m).squaredNorm() > same_thing_gate() * variance;
}

struct Seen {
  const std::string* robot;
  Landmark* landmark;
};

}  // namespace

void ObjectMap::merge(std::map<std::string, RobotMemory>& memories, Frames& frames) {
  std::vector<Seen> seen;
  for (auto& [robot, memory] : memories)
    for (auto& landmark : memory.landmarks()) seen.push_back({&robot, &landmark});
  // What is known best comes first and draws the others to it.
  std::ranges::sort(seen, [](const Seen& a, const Seen& b) {
    return a.landmark->place.covariance_m2.trace() < b.landmark->place.covariance_m2.trace();
  });
  objects_.clear();
  for (const auto& [robot, landmark] : seen) add(*robot, *landmark, frames.of(*robot));
}

void ObjectMap::add(const std::string& robot, Landmark& landmark, const FrameEstimate& frame) {
  const Gaussian2 place = frame.to_map(landmark.place);
  MapObject* nearest = nullptr;
  double nearest_distance = same_thing_gate();
  for (auto& object : objects_) {
    if (object.object_class != landmark.object_class || saw(object, robot)) continue;
    if (is_far(object.place, place)) continue;
    double distance = squared_mahalanobis(object.place, place);
    if (object.id == landmark.object_id) distance /= 4;  // what was one thing stays one
    if (distance >= nearest_distance) continue;
    nearest_distance = distance;
    nearest = &object;
  }
  if (!nearest) {
    const bool taken =
        std::ranges::find(objects_, landmark.object_id, &MapObject::id) != objects_.end();
    if (landmark.object_id == 0 || taken) landmark.object_id = ++last_id_;
    objects_.push_back({landmark.object_id,
                        landmark.object_class,
                        place,
                        landmark.certainty,
                        landmark.last_seen,
                        {robot},
                        {}});
    return;
  }
  landmark.object_id = nearest->id;
  nearest->place = fused(nearest->place, place);
  nearest->certainty = std::max(nearest->certainty, landmark.certainty);
  const bool latest = landmark.last_seen > nearest->last_seen;
  nearest->seen_by.insert(latest ? nearest->seen_by.begin() : nearest->seen_by.end(), robot);
  nearest->last_seen = std::max(nearest->last_seen, landmark.last_seen);
}

void ObjectMap::carry(const std::vector<Carrier>& carriers,
                      std::map<std::string, RobotMemory>& memories, Frames& frames, Time now) {
  for (const auto& carrier : carriers) {
    const bool held = held_.contains(carrier.robot);
    if (carrier.holds && !held) pick_up(carrier, memories, now);
    if (!carrier.holds && held) put_down(carrier.robot, memories, frames, now);
    if (!carrier.holds) continue;
    MapObject& object = held_[carrier.robot];
    object.place = {gripper_of(carrier.pose), 0.0025 * Mat2::Identity()};
    object.last_seen = now;
  }
  for (const auto& [robot, object] : held_) objects_.push_back(object);
}

void ObjectMap::pick_up(const Carrier& carrier, std::map<std::string, RobotMemory>& memories,
                        Time now) {
  const Vec2 gripper = gripper_of(carrier.pose);
  const auto distance = [&](const MapObject& object) {
    return object.object_class == "trash" ? (object.place.mean_m - gripper).norm() : kReach_m;
  };
  const auto nearest = std::ranges::min_element(objects_, {}, distance);
  MapObject object{.object_class = "trash", .seen_by = {carrier.robot}};
  if (nearest != objects_.end() && distance(*nearest) < kReach_m) {
    object = *nearest;
    objects_.erase(nearest);
    for (auto& [robot, memory] : memories) memory.forget(object.id);
  } else {
    object.id = ++last_id_;
  }
  object.certainty = 1;
  object.last_seen = now;
  object.held_by = carrier.robot;
  held_[carrier.robot] = std::move(object);
}

void ObjectMap::put_down(const std::string& robot, std::map<std::string, RobotMemory>& memories,
                         Frames& frames, Time now) {
  const MapObject object = held_.extract(robot).mapped();
  const bool in_basket = std::ranges::any_of(objects_, [&](const MapObject& other) {
    return other.object_class == "basket" &&
           (other.place.mean_m - object.place.mean_m).norm() < kBasketReach_m;
  });
  if (in_basket) return;
  const Gaussian2 in_odom{frames.of(robot).to_odom(object.place.mean_m),
                          object.place.covariance_m2};
  memories[robot].landmarks().push_back({"trash", in_odom, 1, now, now, object.id});
}

bool ObjectMap::is_carried(const Vec2& in_map_m) const {
  return std::ranges::any_of(held_, [&](const auto& held) {
    return (held.second.place.mean_m - in_map_m).norm() < kCarriedWithin_m;
  });
}

}  // namespace galilean::monitor
