// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/map/landmarks/data_association.h"

#include <algorithm>
#include <utility>

#include "monitor/map/estimation/frames.h"

namespace galilean::monitor {
namespace {

using Match = DataAssociation::Match;

/// The prediction must be so certain that the nearest landmark can be the one that is seen. Baskets
/// stand metres apart, and so may be predicted less well.
constexpr double kMaxDeviation_m = 0.25;
constexpr double kMaxBasketDeviation_m = 0.9;
/// A rival fits worse than the best by less than this squared Mahalanobis distance.
constexpr double kRivalMargin = 6;

constexpr double kDuplicate_m = 0.30;  ///< duplicates of one object are no further apart

bool is_matched(std::size_t landmark, const auto& observations) {
  return std::ranges::any_of(observations,
                             [&](const auto& each) { return each.landmark == landmark; });
}

/// Duplicates of one object are no rivals, because a correction by either says the same.
bool has_rival(const auto& matches, const Match& best, const auto& may_be_duplicates) {
  return std::ranges::any_of(matches, [&](const Match& other) {
    const bool same_observation = other.observation == best.observation &&
                                  other.landmark != best.landmark &&
                                  !may_be_duplicates(best.landmark, other.landmark);
    const bool same_landmark =
        other.landmark == best.landmark && other.observation != best.observation;
    return (same_observation || same_landmark) &&
           other.squared_distance < best.squared_distance + kRivalMargin;
  });
}

/// A landmark that is further away cannot be inside the gate, and its prediction is not computed.
/// The gate is one of range and azimuth, whose shape in x and y is bent; kBend allows for that.
bool within_reach(const Vec2& landmark_m, const Vec2& seen_m, const Observation& observation) {
  constexpr double kBend = 4;
  const bool basket = observation.sighting->object_class == "basket";
  const double deviation_m = basket ? kMaxBasketDeviation_m : kMaxDeviation_m;
  const double variance_m2 =
      deviation_m * deviation_m + observation.measurement.in_robot.covariance_m2.trace();
  return (landmark_m - seen_m).squaredNorm() < kBend * association_gate() * variance_m2;
}

}  // namespace

/// A robot that shares nothing with the others may stand anywhere. To take its baskets for theirs
/// would be a guess.
double DataAssociation::max_deviation_m(const Landmark& landmark, const std::string& robot) const {
  const bool placed = robots_.has_known_start(robot) || share_landmarks_.contains(robot);
  return landmark.object_class == "basket" && placed ? kMaxBasketDeviation_m : kMaxDeviation_m;
}

std::vector<DataAssociation::Match> DataAssociation::matches(
    const std::vector<Observation>& observations, const std::string& observer) const {
  const auto robot = robots_.block(observer);
  const Pose2 pose = robots_.pose(observer);
  const auto& landmarks = landmarks_.all();
  std::vector<Match> matches;
  for (std::size_t i = 0; i < observations.size(); ++i) {
    const Observation& observation = observations[i];
    if (observation.landmark) continue;
    const Vec2 seen_m = in_map(pose, observation.measurement.in_robot.mean_m);
    for (std::size_t j = 0; j < landmarks.size(); ++j) {
      if (!within_reach(joint_.position(landmarks[j].block), seen_m, observation)) continue;
      if (landmarks[j].object_class != observation.sighting->object_class ||
          is_matched(j, observations))
        continue;
      const auto predicted = predict_measurement(joint_, robot, landmarks[j].block);
      const Compatibility compatibility =
          compatibility_of(joint_, predicted, observation.measurement.in_robot);
      if (compatibility.squared_distance < association_gate() &&
          compatibility.deviation_m < max_deviation_m(landmarks[j], observer))
        matches.push_back({compatibility.squared_distance, i, j});
    }
  }
  return matches;
}

bool DataAssociation::may_be_duplicates(std::size_t a, std::size_t b) const {
  const Landmark &first = landmarks_.all()[a], &second = landmarks_.all()[b];
  const Vec2 apart = joint_.position(first.block) - joint_.position(second.block);
  return apart.norm() < kDuplicate_m && may_be_same(first, second);
}

std::optional<DataAssociation::Match> DataAssociation::next(
    const std::vector<Observation>& observations, const std::string& observer) const {
  std::vector<Match> all = matches(observations, observer);
  if (all.empty()) return std::nullopt;
  const auto duplicates = [this](std::size_t a, std::size_t b) { return may_be_duplicates(a, b); };
  for (Match& match : all) match.is_sure = !has_rival(all, match, duplicates);
  return *std::ranges::min_element(all, {}, [](const Match& match) {
    return std::pair(!match.is_sure, match.squared_distance);
  });
}

void DataAssociation::note(const std::vector<Observation>& observations,
                           const std::string& observer) {
  for (const Observation& each : observations)
    if (each.landmark && landmarks_.all()[*each.landmark].seen_by.size() > 1)
      share_landmarks_.insert(observer);
}

}  // namespace galilean::monitor
