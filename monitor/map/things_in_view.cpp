#include <algorithm>
#include <cmath>
#include <utility>

#include "monitor/map/frames.h"
#include "monitor/map/things.h"

namespace galilean::monitor {
namespace {

/// Where to look must be known so well that the nearest thing can be the one meant: baskets stand
/// metres apart.
constexpr double kMostDeviation_m = 0.25;
constexpr double kMostBasketDeviation_m = 0.9;
/// Another thing that fits nearly as well, by squared Mahalanobis distance.
constexpr double kRivalMargin = 6;

constexpr double kNotedTwice_m = 0.30;  ///< two notes of one thing may be so far apart

/// What a camera must see if it is there: not so near that the blob leaves the picture, not so far
/// that it is small, and not at the picture's edge.
constexpr double kPlainViewFrom_m = 0.6;
constexpr double kPictureEdge_rad = 0.10;
constexpr double kHides_rad = 0.15;
constexpr double kLongestPeriod_s = 0.5;
constexpr Duration kOrientedFor = std::chrono::seconds(3);
constexpr double kPlainViewDeviation_m = 0.2;

bool is_matched(std::size_t thing, const auto& seen) {
  return std::ranges::any_of(seen, [&](const auto& each) { return each.thing == thing; });
}

/// `noted_twice`: two things that may be notes of one are no rivals; either tells the same.
bool has_rival(const auto& matches, const auto& best, const auto& noted_twice) {
  return std::ranges::any_of(matches, [&](const auto& other) {
    const bool same_sighting = other.seen == best.seen && other.thing != best.thing &&
                               !noted_twice(best.thing, other.thing);
    const bool same_thing = other.thing == best.thing && other.seen != best.seen;
    return (same_sighting || same_thing) &&
           other.squared_distance < best.squared_distance + kRivalMargin;
  });
}

/// What lies further away fits by no means, and need not be reckoned. A bend of so much is allowed
/// for: the gate is one of range and bearing.
bool within_reach(const Vec2& thing_m, const Vec2& seen_m, const auto& seen) {
  constexpr double kBend = 4;
  const bool basket = seen.sighting->object_class == "basket";
  const double deviation_m = basket ? kMostBasketDeviation_m : kMostDeviation_m;
  const double variance_m2 =
      deviation_m * deviation_m + seen.bearing.from_robot.covariance_m2.trace();
  return (thing_m - seen_m).squaredNorm() < kBend * same_thing_gate() * variance_m2;
}

bool is_hidden(const msg::Sightings& frame, double azimuth_rad, double range_m) {
  return std::ranges::any_of(frame.items, [&](const auto& other) {
    return other.range_m < range_m &&
           std::abs(wrap_angle(other.azimuth_rad - azimuth_rad)) < kHides_rad;
  });
}

bool in_plain_view(const msg::Sightings& frame, const Vec2& from_robot_m) {
  const double range_m = from_robot_m.norm();
  if (range_m <= kPlainViewFrom_m || range_m >= Things::kPlainViewTo_m) return false;
  const double azimuth_rad = std::atan2(from_robot_m.y(), from_robot_m.x());
  return std::abs(azimuth_rad) < frame.view_angle_rad / 2 - kPictureEdge_rad &&
         !is_hidden(frame, azimuth_rad, range_m);
}

/// Something of its class is about there.
bool is_seen(const msg::Sightings& frame, const Thing& thing, const Vec2& from_robot_m) {
  constexpr double kAbout_m = 0.4;
  return std::ranges::any_of(frame.items, [&](const auto& sighting) {
    const Vec2 at_m =
        rotated(Vec2(sighting.x_m - frame.x_m, sighting.y_m - frame.y_m), -frame.heading_rad);
    return sighting.object_class == thing.object_class && (at_m - from_robot_m).norm() < kAbout_m;
  });
}

}  // namespace

/// One that has nothing in common with the others may stand anywhere: to take its baskets for
/// theirs would be a guess.
double Things::most_deviation_m(const Thing& thing, const std::string& robot) const {
  const bool placed = robots_.was_placed(robot) || among_others_.contains(robot);
  return thing.object_class == "basket" && placed ? kMostBasketDeviation_m : kMostDeviation_m;
}

std::optional<Things::Match> Things::match(const std::vector<Seen>& seen,
                                           const std::string& observer) const {
  const auto robot = robots_.part(observer);
  const Pose2 pose = robots_.pose(observer);
  std::vector<Match> matches;
  for (std::size_t i = 0; i < seen.size(); ++i) {
    if (seen[i].thing) continue;
    const Vec2 in_map_m =
        pose.position_m + rotated(seen[i].bearing.from_robot.mean_m, pose.heading_rad);
    for (std::size_t j = 0; j < things_.size(); ++j) {
      if (!within_reach(joint_.position(things_[j].part), in_map_m, seen[i])) continue;
      if (things_[j].object_class != seen[i].sighting->object_class || is_matched(j, seen))
        continue;
      const auto expected = expected_sighting(joint_, robot, things_[j].part);
      const Fit fit = fit_of(joint_, expected, seen[i].bearing.from_robot);
      if (fit.squared_distance < same_thing_gate() &&
          fit.deviation_m < most_deviation_m(things_[j], observer))
        matches.push_back({fit.squared_distance, i, j});
    }
  }
  if (matches.empty()) return std::nullopt;
  const auto noted_twice = [&](std::size_t a, std::size_t b) {
    const Vec2 apart = joint_.position(things_[a].part) - joint_.position(things_[b].part);
    return apart.norm() < kNotedTwice_m && may_be_one(things_[a], things_[b]);
  };
  for (auto& match : matches) match.is_sure = !has_rival(matches, match, noted_twice);
  return *std::ranges::min_element(matches, {}, [](const Match& match) {
    return std::pair(!match.is_sure, match.squared_distance);
  });
}

void Things::note_orientation(const msg::Sightings& frame, const std::vector<Seen>& seen,
                              Time now) {
  for (const auto& each : seen) {
    if (!each.thing) continue;
    const Thing& thing = things_[*each.thing];
    if (thing.seen_by.size() > 1) among_others_.insert(frame.robot);
    if (!thing.is_new_of(frame.robot, now) || robots_.all().size() == 1)
      oriented_[frame.robot] = now;
  }
}

// One that recognises nothing may be elsewhere than it is believed to be, and misses what is there.
double Things::looked_s(const std::string& robot, Time now) {
  const auto before = std::exchange(last_frame_.try_emplace(robot, now).first->second, now);
  if (now - oriented_.try_emplace(robot, now).first->second > kOrientedFor) return 0;
  return std::min(to_seconds(now - before), kLongestPeriod_s);
}

void Things::doubt_unseen(const msg::Sightings& frame, const std::vector<Seen>& seen,
                          double for_s) {
  if (for_s <= 0) return;
  const auto robot = robots_.part(frame.robot);
  const Pose2 pose = robots_.pose(frame.robot);
  for (std::size_t j = 0; j < things_.size(); ++j) {
    Thing& thing = things_[j];
    if (thing.object_class == "obstacle" || is_matched(j, seen)) continue;
    if (!in_plain_view(frame, from_robot(pose, joint_.position(thing.part)))) continue;
    const auto expected = expected_sighting(joint_, robot, thing.part);
    const Fit fit = fit_of(joint_, expected, {expected.from_robot_m, Mat2::Identity()});
    if (fit.deviation_m < kPlainViewDeviation_m) thing.doubt(for_s);
  }
}

void Things::miss(const msg::Sightings& frame, const Lookout& from) {
  if (from.for_s <= 0) return;
  for (auto& thing : things_) {
    const Vec2 at_m = from_robot(from.pose, joint_.position(thing.part));
    if (thing.object_class == "obstacle" || !in_plain_view(frame, at_m)) continue;
    const double variance_m2 = joint_.covariance(thing.part).trace() +
                               from.covariance.topLeftCorner<2, 2>().trace() +
                               at_m.squaredNorm() * from.covariance(2, 2);
    if (variance_m2 < 2 * kPlainViewDeviation_m * kPlainViewDeviation_m &&
        !is_seen(frame, thing, at_m))
      thing.doubt(from.for_s);
  }
}

}  // namespace galilean::monitor
