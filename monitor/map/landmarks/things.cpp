#include "monitor/map/landmarks/things.h"

#include <Eigen/LU>
#include <algorithm>
#include <utility>

namespace galilean::monitor {
namespace {

constexpr double kSamePlace_m = 0.02;     ///< what is known of two notes of one thing
constexpr double kTouchedAgain_m = 0.20;  ///< obstacles nearer to one another are one

constexpr double kFacingUnknown_rad = 0.12;

/// A piece of trash that is so far from where it was expected, by squared Mahalanobis distance, was
/// rather pushed than is its observer elsewhere.
constexpr double kMovedDistance = 4;

constexpr double kToldTwice_m = 0.25;
constexpr double kApart_m = 0.05;  ///< by which two notes of one thing may err unbeknown

constexpr double kVague_m = 0.75;

bool is_thing(const msg::Sighting& sighting) {
  return sighting.object_class != "robot" && sighting.object_class != "obstacle";
}

}  // namespace

Gaussian2 Things::place(const Thing& thing) const {
  return {joint_.position(thing.part), joint_.covariance(thing.part)};
}

/// Seen from far away, it may stand anywhere within metres: that is no place to tell.
bool Things::tell(const Thing& thing) const {
  return thing.told() && joint_.covariance(thing.part).trace() <= kVague_m * kVague_m &&
         !may_be_told_twice(thing);
}

bool Things::may_be_told_twice(const Thing& thing) const {
  const Gaussian2 at = place(thing);
  return std::ranges::any_of(things_, [&](const Thing& other) {
    const Vec2 apart = at.mean_m - joint_.position(other.part);
    if (apart.norm() > kToldTwice_m || !other.told() || !may_be_one(thing, other)) return false;
    if (joint_.covariance(other.part).trace() >= at.covariance_m2.trace()) return false;
    const JointGaussian::Term difference[] = {{other.part, Mat2::Identity()},
                                              {thing.part, -Mat2::Identity()}};
    const Mat2 covariance = joint_.covariance(difference) + kApart_m * kApart_m * Mat2::Identity();
    return apart.dot(covariance.inverse() * apart) < same_thing_gate();
  });
}

Thing* Things::find(std::uint64_t id) {
  const auto found = std::ranges::find(things_, id, &Thing::id);
  return found == things_.end() ? nullptr : &*found;
}

Lookout Things::see(const msg::Sightings& frame, Time now) {
  const auto robot = robots_.part(frame.robot);
  std::vector<Seen> seen;
  for (const auto& sighting : frame.items)
    if (const auto bearing = bearing_of(sighting, frame); bearing && is_thing(sighting))
      seen.push_back({&sighting, *bearing, std::nullopt});
  // One by one: each that is sure tells better where to look for the next.
  while (const auto next = match(seen, frame.robot)) {
    seen[next->seen].thing = next->thing;
    Thing& thing = things_[next->thing];
    thing.confirm(frame.robot, now);
    if (!seen[next->seen].bearing.whole) continue;
    const bool moved = thing.object_class == "trash" && next->squared_distance > kMovedDistance;
    if (moved)
      put(thing, frame.robot, seen[next->seen].bearing.from_robot);
    else if (next->is_sure && tells_anything(thing, frame.robot, now))
      correct(thing, seen[next->seen].bearing, robot);
  }
  recognise_baskets(frame.robot, seen);
  note_orientation(frame, seen, now);
  const double for_s = looked_s(frame.robot, now);
  doubt_unseen(frame, seen, for_s);
  for (const auto& each : seen)
    if (!each.thing && each.bearing.whole)
      note(each.sighting->object_class, frame.robot, each.bearing.from_robot, 1 - Thing::kDoubtKept,
           now);
  return {robots_.pose(frame.robot), joint_.covariance(robot).topLeftCorner<3, 3>(), for_s};
}

/// What a robot found while it hardly knew where it faces tells it nothing of that: to go by it all
/// the same would make the filter sure of what it only repeats.
bool Things::tells_anything(const Thing& thing, const std::string& robot, Time now) const {
  const double heading_variance = joint_.covariance(robots_.part(robot))(2, 2);
  return heading_variance < kFacingUnknown_rad * kFacingUnknown_rad || !thing.is_new_of(robot, now);
}

void Things::correct(const Thing& thing, const Bearing& bearing, JointGaussian::Part robot) {
  const auto expected = expected_sighting(joint_, robot, thing.part);
  correct_by(joint_, expected, bearing.from_robot);
}

void Things::note(const std::string& object_class, const std::string& robot,
                  const Gaussian2& from_robot, double certainty, Time now, std::uint64_t id) {
  const auto placed = place_of(joint_, robots_.part(robot), from_robot);
  if (object_class == "obstacle")
    for (auto& thing : things_)
      if (thing.object_class == object_class &&
          (place(thing).mean_m - placed.in_map_m).norm() < kTouchedAgain_m) {
        thing.confirm(robot, now);
        return;
      }
  make_room();
  Thing& thing = things_.emplace_back();
  thing.id = id ? id : ids_.next();
  thing.object_class = object_class;
  thing.part = joint_.add(placed.in_map_m, placed.of, placed.noise_m2);
  thing.certainty = certainty;
  thing.sightings = id ? Thing::kLeastSightings : 1;
  thing.first_seen = thing.faded = thing.last_seen = thing.seen_by[robot] = now;
}

Eigen::AlignedBox2d Things::extent_m() const {
  Eigen::AlignedBox2d box;
  for (const auto& thing : things_) box.extend(joint_.position(thing.part));
  return box;
}

void Things::fade(Time now) {
  for (auto& thing : things_) thing.fade(now);
  for (const auto& thing : things_)
    if (thing.forgotten(now)) joint_.remove(thing.part);
  std::erase_if(things_, [&](const Thing& thing) { return thing.forgotten(now); });
}

void Things::forget(std::uint64_t id) {
  if (const Thing* thing = find(id)) joint_.remove(thing->part);
  std::erase_if(things_, [&](const Thing& thing) { return thing.id == id; });
}

void Things::forget_new_of(const std::string& robot, Time now) {
  const auto is_new = [&](const Thing& thing) {
    return thing.object_class != "obstacle" && thing.is_new_of(robot, now);
  };
  for (const auto& thing : things_)
    if (is_new(thing)) joint_.remove(thing.part);
  std::erase_if(things_, is_new);
}

void Things::make_room() {
  if (things_.size() < kMostThings) return;
  forget(std::ranges::min_element(things_, {}, &Thing::certainty)->id);
}

void Things::unite(std::uint64_t kept, std::uint64_t same) {
  Thing* thing = find(kept);
  const Thing* other = find(same);
  if (!thing || !other || thing == other) return;
  const JointGaussian::Term difference[] = {{other->part, Mat2::Identity()},
                                            {thing->part, -Mat2::Identity()}};
  joint_.correct(difference, joint_.position(thing->part) - joint_.position(other->part),
                 kSamePlace_m * kSamePlace_m * Mat2::Identity());
  thing->absorb(*other);
  forget(same);
}

}  // namespace galilean::monitor
