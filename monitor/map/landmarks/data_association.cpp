#include <algorithm>
#include <utility>

#include "monitor/map/estimation/frames.h"
#include "monitor/map/landmarks/landmark_map.h"

namespace galilean::monitor {
namespace {

/// Where to look must be known so well that the nearest landmark can be the one meant: baskets
/// stand metres apart.
constexpr double kMostDeviation_m = 0.25;
constexpr double kMostBasketDeviation_m = 0.9;
/// Another landmark that fits nearly as well, by squared Mahalanobis distance.
constexpr double kRivalMargin = 6;

constexpr double kDuplicate_m = 0.30;  ///< two notes of one landmark may be so far apart

bool is_matched(std::size_t landmark, const auto& seen) {
  return std::ranges::any_of(seen, [&](const auto& each) { return each.landmark == landmark; });
}

/// `may_be_duplicates`: two landmarks that may be notes of one are no rivals; either tells the
/// same.
bool has_rival(const auto& matches, const auto& best, const auto& may_be_duplicates) {
  return std::ranges::any_of(matches, [&](const auto& other) {
    const bool same_sighting = other.seen == best.seen && other.landmark != best.landmark &&
                               !may_be_duplicates(best.landmark, other.landmark);
    const bool same_thing = other.landmark == best.landmark && other.seen != best.seen;
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

}  // namespace

/// One that has nothing in common with the others may stand anywhere: to take its baskets for
/// theirs would be a guess.
double LandmarkMap::max_deviation_m(const Landmark& landmark, const std::string& robot) const {
  const bool placed = robots_.was_placed(robot) || among_others_.contains(robot);
  return landmark.object_class == "basket" && placed ? kMostBasketDeviation_m : kMostDeviation_m;
}

std::optional<LandmarkMap::Match> LandmarkMap::match(const std::vector<Seen>& seen,
                                                     const std::string& observer) const {
  const auto robot = robots_.part(observer);
  const Pose2 pose = robots_.pose(observer);
  std::vector<Match> matches;
  for (std::size_t i = 0; i < seen.size(); ++i) {
    if (seen[i].landmark) continue;
    const Vec2 in_map_m =
        pose.position_m + rotated(seen[i].bearing.from_robot.mean_m, pose.heading_rad);
    for (std::size_t j = 0; j < landmarks_.size(); ++j) {
      if (!within_reach(joint_.position(landmarks_[j].part), in_map_m, seen[i])) continue;
      if (landmarks_[j].object_class != seen[i].sighting->object_class || is_matched(j, seen))
        continue;
      const auto expected = expected_sighting(joint_, robot, landmarks_[j].part);
      const Fit fit = fit_of(joint_, expected, seen[i].bearing.from_robot);
      if (fit.squared_distance < same_thing_gate() &&
          fit.deviation_m < max_deviation_m(landmarks_[j], observer))
        matches.push_back({fit.squared_distance, i, j});
    }
  }
  if (matches.empty()) return std::nullopt;
  const auto may_be_duplicates = [&](std::size_t a, std::size_t b) {
    const Vec2 apart = joint_.position(landmarks_[a].part) - joint_.position(landmarks_[b].part);
    return apart.norm() < kDuplicate_m && may_be_same(landmarks_[a], landmarks_[b]);
  };
  for (auto& match : matches) match.is_sure = !has_rival(matches, match, may_be_duplicates);
  return *std::ranges::min_element(matches, {}, [](const Match& match) {
    return std::pair(!match.is_sure, match.squared_distance);
  });
}

void LandmarkMap::note_recognition(const msg::Sightings& frame, const std::vector<Seen>& seen,
                                   Time now) {
  for (const auto& each : seen) {
    if (!each.landmark) continue;
    const Landmark& landmark = landmarks_[*each.landmark];
    if (landmark.seen_by.size() > 1) among_others_.insert(frame.robot);
    if (!landmark.is_recent_of(frame.robot, now) || robots_.all().size() == 1)
      oriented_[frame.robot] = now;
  }
}

}  // namespace galilean::monitor
