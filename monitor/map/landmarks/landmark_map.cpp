#include "monitor/map/landmarks/landmark_map.h"

#include <Eigen/LU>
#include <algorithm>
#include <utility>

namespace galilean::monitor {
namespace {

constexpr double kSamePlace_m = 0.02;     ///< what is known of two notes of one landmark
constexpr double kTouchedAgain_m = 0.20;  ///< obstacles nearer to one another are one

constexpr double kFacingUnknown_rad = 0.12;

/// A piece of trash that is so far from where it was expected, by squared Mahalanobis distance, was
/// rather pushed than is its observer elsewhere.
constexpr double kMovedDistance = 4;

constexpr double kDuplicate_m = 0.25;
constexpr double kApart_m = 0.05;  ///< by which two notes of one landmark may err unbeknown

constexpr double kVague_m = 0.75;

bool is_stored(const msg::Sighting& sighting) {
  return sighting.object_class != "robot" && sighting.object_class != "obstacle";
}

}  // namespace

Gaussian2 LandmarkMap::place(const Landmark& landmark) const {
  return {joint_.position(landmark.part), joint_.covariance(landmark.part)};
}

/// Seen from far away, it may stand anywhere within metres: that is no place to tell.
bool LandmarkMap::is_published(const Landmark& landmark) const {
  return landmark.is_publishable() &&
         joint_.covariance(landmark.part).trace() <= kVague_m * kVague_m &&
         !is_duplicate_candidate(landmark);
}

bool LandmarkMap::is_duplicate_candidate(const Landmark& landmark) const {
  const Gaussian2 at = place(landmark);
  return std::ranges::any_of(landmarks_, [&](const Landmark& other) {
    const Vec2 apart = at.mean_m - joint_.position(other.part);
    if (apart.norm() > kDuplicate_m || !other.is_publishable() || !may_be_same(landmark, other))
      return false;
    if (joint_.covariance(other.part).trace() >= at.covariance_m2.trace()) return false;
    const JointGaussian::Term difference[] = {{other.part, Mat2::Identity()},
                                              {landmark.part, -Mat2::Identity()}};
    const Mat2 covariance = joint_.covariance(difference) + kApart_m * kApart_m * Mat2::Identity();
    return apart.dot(covariance.inverse() * apart) < same_thing_gate();
  });
}

Landmark* LandmarkMap::find(std::uint64_t id) {
  const auto found = std::ranges::find(landmarks_, id, &Landmark::id);
  return found == landmarks_.end() ? nullptr : &*found;
}

Viewpoint LandmarkMap::update(const msg::Sightings& frame, Time now) {
  const auto robot = robots_.part(frame.robot);
  std::vector<Seen> seen;
  for (const auto& sighting : frame.items)
    if (const auto bearing = bearing_of(sighting, frame); bearing && is_stored(sighting))
      seen.push_back({&sighting, *bearing, std::nullopt});
  // One by one: each that is sure tells better where to look for the next.
  while (const auto next = match(seen, frame.robot)) {
    seen[next->seen].landmark = next->landmark;
    Landmark& landmark = landmarks_[next->landmark];
    landmark.observe(frame.robot, now);
    if (!seen[next->seen].bearing.whole) continue;
    const bool moved = landmark.object_class == "trash" && next->squared_distance > kMovedDistance;
    if (moved)
      replace(landmark, frame.robot, seen[next->seen].bearing.from_robot);
    else if (next->is_sure && is_informative(landmark, frame.robot, now))
      correct(landmark, seen[next->seen].bearing, robot);
  }
  recognise_baskets(frame.robot, seen);
  note_recognition(frame, seen, now);
  const double for_s = looked_s(frame.robot, now);
  penalize_unseen(frame, seen, for_s);
  for (const auto& each : seen)
    if (!each.landmark && each.bearing.whole)
      add_contact(each.sighting->object_class, frame.robot, each.bearing.from_robot,
                  1 - Landmark::kDoubtFactor, now);
  return {robots_.pose(frame.robot), joint_.covariance(robot).topLeftCorner<3, 3>(), for_s};
}

/// What a robot found while it hardly knew where it faces tells it nothing of that: to go by it all
/// the same would make the filter sure of what it only repeats.
bool LandmarkMap::is_informative(const Landmark& landmark, const std::string& robot,
                                 Time now) const {
  const double heading_variance = joint_.covariance(robots_.part(robot))(2, 2);
  return heading_variance < kFacingUnknown_rad * kFacingUnknown_rad ||
         !landmark.is_recent_of(robot, now);
}

void LandmarkMap::correct(const Landmark& landmark, const Bearing& bearing,
                          JointGaussian::Part robot) {
  const auto expected = expected_sighting(joint_, robot, landmark.part);
  correct_by(joint_, expected, bearing.from_robot);
}

void LandmarkMap::add_contact(const std::string& object_class, const std::string& robot,
                              const Gaussian2& from_robot, double certainty, Time now,
                              std::uint64_t id) {
  const auto placed = place_of(joint_, robots_.part(robot), from_robot);
  if (object_class == "obstacle")
    for (auto& landmark : landmarks_)
      if (landmark.object_class == object_class &&
          (place(landmark).mean_m - placed.in_map_m).norm() < kTouchedAgain_m) {
        landmark.observe(robot, now);
        return;
      }
  make_room();
  Landmark& landmark = landmarks_.emplace_back();
  landmark.id = id ? id : ids_.next();
  landmark.object_class = object_class;
  landmark.part = joint_.add(placed.in_map_m, placed.of, placed.noise_m2);
  landmark.certainty = certainty;
  landmark.sightings = id ? Landmark::kConfirmingSightings : 1;
  landmark.first_seen = landmark.decayed = landmark.last_seen = landmark.seen_by[robot] = now;
}

Eigen::AlignedBox2d LandmarkMap::extent_m() const {
  Eigen::AlignedBox2d box;
  for (const auto& landmark : landmarks_) box.extend(joint_.position(landmark.part));
  return box;
}

void LandmarkMap::decay(Time now) {
  for (auto& landmark : landmarks_) landmark.decay(now);
  for (const auto& landmark : landmarks_)
    if (landmark.is_expired(now)) joint_.remove(landmark.part);
  std::erase_if(landmarks_, [&](const Landmark& landmark) { return landmark.is_expired(now); });
}

void LandmarkMap::remove(std::uint64_t id) {
  if (const Landmark* landmark = find(id)) joint_.remove(landmark->part);
  std::erase_if(landmarks_, [&](const Landmark& landmark) { return landmark.id == id; });
}

void LandmarkMap::discard_recent(const std::string& robot, Time now) {
  const auto is_new = [&](const Landmark& landmark) {
    return landmark.object_class != "obstacle" && landmark.is_recent_of(robot, now);
  };
  for (const auto& landmark : landmarks_)
    if (is_new(landmark)) joint_.remove(landmark.part);
  std::erase_if(landmarks_, is_new);
}

void LandmarkMap::make_room() {
  if (landmarks_.size() < kMaxLandmarks) return;
  remove(std::ranges::min_element(landmarks_, {}, &Landmark::certainty)->id);
}

void LandmarkMap::merge(std::uint64_t kept, std::uint64_t same) {
  Landmark* landmark = find(kept);
  const Landmark* other = find(same);
  if (!landmark || !other || landmark == other) return;
  const JointGaussian::Term difference[] = {{other->part, Mat2::Identity()},
                                            {landmark->part, -Mat2::Identity()}};
  joint_.correct(difference, joint_.position(landmark->part) - joint_.position(other->part),
                 kSamePlace_m * kSamePlace_m * Mat2::Identity());
  landmark->merge(*other);
  remove(same);
}

}  // namespace galilean::monitor
