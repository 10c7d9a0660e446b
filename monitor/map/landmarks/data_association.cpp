// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/map/landmarks/data_association.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "monitor/map/estimation/frames.h"
#include "monitor/map/landmarks/joint_compatibility.h"

namespace galilean::monitor {
namespace {

using Match = DataAssociation::Match;

/// The largest standard deviation of a prediction with which the nearest landmark is taken for the
/// one that is seen. It is larger for baskets, because these stand metres apart.
constexpr double kMaxDeviation_m = 0.25;
constexpr double kMaxBasketDeviation_m = 0.9;
/// Up to this standard deviation one piece of trash tells where its observer is.
constexpr double kClear_m = 0.18;
/// The best match has a rival if another match's squared Mahalanobis distance is larger by less
/// than this.
constexpr double kRivalMargin = 6;

constexpr double kDuplicate_m = 0.30;  ///< duplicates of one object are no further apart

bool is_matched(std::size_t landmark, const auto& observations) {
  return std::ranges::any_of(observations,
                             [&](const auto& each) { return each.landmark == landmark; });
}

/// Returns whether another match is nearly as good. Duplicates of one object are no rivals, because
/// they give the same correction.
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

/// Returns false if a landmark is too far away to be inside the gate, which saves its prediction.
/// The gate is one of range and azimuth, so its shape in x and y is bent, and kBend allows for
/// that.
bool within_reach(const Vec2& landmark_m, const Vec2& seen_m, const Observation& observation) {
  constexpr double kBend = 4;
  const bool basket = observation.sighting->object_class == "basket";
  const double deviation_m = basket ? kMaxBasketDeviation_m : kMaxDeviation_m;
  const double variance_m2 =
      deviation_m * deviation_m + observation.measurement.in_robot.covariance_m2.trace();
  return (landmark_m - seen_m).squaredNorm() < kBend * association_gate() * variance_m2;
}

}  // namespace

// A robot that shares no landmarks with the others may stand anywhere, so its basket need not be
// the nearest one that they know.
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
        matches.push_back({compatibility.squared_distance, i, j, compatibility.deviation_m});
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
    const std::vector<Observation>& observations, const std::string& observer, Time now) const {
  std::vector<Match> all = matches(observations, observer);
  if (all.empty()) return std::nullopt;
  const auto duplicates = [this](std::size_t a, std::size_t b) { return may_be_duplicates(a, b); };
  for (Match& match : all) match.is_sure = !has_rival(all, match, duplicates);
  Match& best = *std::ranges::min_element(all, {}, [](const Match& match) {
    return std::pair(!match.is_sure, match.squared_distance);
  });
  best.is_supported = is_supported(best, all, observations, observer, now);
  return best;
}

// What the robot alone added lately has the error of its pose, and so supports any pose.
bool DataAssociation::is_supported(const Match& match, const std::vector<Match>& all,
                                   const std::vector<Observation>& observations,
                                   const std::string& observer, Time now) const {
  const auto& landmarks = landmarks_.all();
  if (landmarks[match.landmark].object_class == "basket" || match.deviation_m < kClear_m)
    return true;
  const auto robot = robots_.block(observer);
  const double heading_rad = robots_.pose(observer).heading_rad;
  const double deviation_rad = std::sqrt(joint_.covariance(robot)(2, 2));
  const auto seen_m = [&](std::size_t i) { return observations[i].measurement.in_robot.mean_m; };
  const auto known_m = [&](std::size_t j) -> Vec2 { return joint_.position(landmarks[j].block); };
  const auto supports = [&](std::size_t observation, std::size_t landmark) {
    const bool is_other = observation != match.observation && landmark != match.landmark;
    return is_other && landmarks[landmark].is_confirmed() &&
           !landmarks[landmark].is_recent_of(observer, now) &&
           are_jointly_compatible(
               rotated(seen_m(observation) - seen_m(match.observation), heading_rad),
               known_m(landmark) - known_m(match.landmark), deviation_rad);
  };
  for (std::size_t i = 0; i < observations.size(); ++i)
    if (const auto& each = observations[i];
        each.landmark && each.measurement.complete && supports(i, *each.landmark))
      return true;
  return std::ranges::any_of(
      all, [&](const Match& other) { return supports(other.observation, other.landmark); });
}

void DataAssociation::note(const std::vector<Observation>& observations,
                           const std::string& observer) {
  for (const Observation& each : observations)
    if (each.landmark && landmarks_.all()[*each.landmark].seen_by.size() > 1)
      share_landmarks_.insert(observer);
}

}  // namespace galilean::monitor
