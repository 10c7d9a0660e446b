// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/map/relocalization/landmark_merger.h"

#include <Eigen/LU>
#include <algorithm>

#include "monitor/map/relocalization/transform_blocks.h"

namespace galilean::monitor {
namespace {

constexpr double kWellKnown_m = 0.10;  ///< largest standard deviation between two landmarks
constexpr double kOtherRobotDuplicate_m = 0.30;  ///< duplicates by two robots are no further apart
constexpr double kSameRobotDuplicate_m = 0.12;   ///< duplicates by one robot are no further apart
constexpr double kMatchedWithin_m = 1.2;
constexpr double kPointDeviation_m = 0.08;
/// The standard deviation of a point in a search. It is smaller because all pairs of a class are
/// tried, and of two dozen landmarks in a room some agree by chance.
constexpr double kSearchDeviation_m = 0.06;
constexpr double kLeastSpread_m = 0.8;

bool share_an_observer(const Landmark& a, const Landmark& b) {
  return std::ranges::any_of(a.seen_by,
                             [&](const auto& seen) { return b.was_seen_by(seen.first); });
}

std::array<JointGaussian::Term, 2> difference(const Landmark& a, const Landmark& b) {
  return {{{a.block, Mat2::Identity()}, {b.block, -Mat2::Identity()}}};
}

}  // namespace

void LandmarkMerger::merge_neighbours() {
  while (const auto pair = nearest_neighbours()) landmarks_.merge(pair->kept, pair->duplicate);
}

std::optional<LandmarkMerger::Pair> LandmarkMerger::nearest_neighbours() const {
  std::optional<Pair> best;
  const auto& all = landmarks_.all();
  for (std::size_t i = 0; i < all.size(); ++i)
    for (std::size_t j = i + 1; j < all.size(); ++j) {
      const Vec2 apart = joint_.position(all[i].block) - joint_.position(all[j].block);
      if (apart.norm() > kOtherRobotDuplicate_m || !may_be_same(all[i], all[j])) continue;
      const double within_m =
          share_an_observer(all[i], all[j]) ? kSameRobotDuplicate_m : kOtherRobotDuplicate_m;
      if (apart.norm() > within_m) continue;
      const Mat2 covariance = joint_.covariance(difference(all[i], all[j]));
      if (covariance.trace() > 2 * kWellKnown_m * kWellKnown_m) continue;
      const double distance = apart.dot(covariance.inverse() * apart);
      if (distance < association_gate() && (!best || distance < best->squared_distance))
        best = Pair{std::min(all[i].id, all[j].id), std::max(all[i].id, all[j].id), distance};
    }
  return best;
}

void LandmarkMerger::align(Time now, const std::vector<LabelledPoint>& known_to_others) {
  now_ = now;
  const auto& robots = robots_.all();
  if (robots.empty()) return;
  auto next = robots.upper_bound(last_aligned_);
  if (next == robots.end()) next = robots.begin();
  last_aligned_ = next->first;
  merge_agreeing(next->first);
  relocalizer_.relocalize(next->first, now, known_to_others);
  if (next != robots.begin() && !shares_landmarks(next->first)) align_unknown(next->first);
}

std::vector<Correspondence> LandmarkMerger::correspondences(const std::string& robot,
                                                            bool inside_gate) const {
  std::vector<Correspondence> result;
  const auto& all = landmarks_.all();
  const Time since = inside_gate ? now_ - Landmark::kObservationWindow : Time::min();
  for (const auto& own : all) {
    if (!own.is_confirmed() || !own.was_seen_by(robot, since)) continue;
    for (const auto& other : all) {
      if (!other.is_confirmed() || other.was_seen_by(robot, since) || !may_be_same(own, other))
        continue;
      const Vec2 own_m = joint_.position(own.block), other_m = joint_.position(other.block);
      if (inside_gate) {
        const Vec2 apart = own_m - other_m;
        if (apart.norm() > kMatchedWithin_m) continue;
        const Mat2 covariance = joint_.covariance(difference(own, other)) +
                                kPointDeviation_m * kPointDeviation_m * Mat2::Identity();
        if (apart.dot(covariance.inverse() * apart) > association_gate()) continue;
      }
      result.push_back({other_m, own_m, other.id, own.id});
    }
  }
  return result;
}

void LandmarkMerger::merge_agreeing(const std::string& robot) {
  const auto fit =
      fit_rigid_transform(correspondences(robot, true), kPointDeviation_m, kLeastAgreeing);
  if (fit.agreeing.empty() || fit.spread_m < kLeastSpread_m) return;
  for (const auto& pair : fit.agreeing)
    landmarks_.merge(std::min(pair.map_index, pair.other_index),
                     std::max(pair.map_index, pair.other_index));
}

bool LandmarkMerger::shares_landmarks(const std::string& robot) const {
  return std::ranges::any_of(landmarks_.all(), [&](const Landmark& landmark) {
    return landmark.seen_by.size() > 1 && landmark.was_seen_by(robot);
  });
}

void LandmarkMerger::align_unknown(const std::string& robot) {
  const auto all = correspondences(robot, false);
  const auto fit = fit_rigid_transform(all, kSearchDeviation_m, kLeastForUnknown);
  const auto before = candidates_.find(robot);
  if (fit.agreeing.empty() || fit.spread_m < kLeastSpread_m) {
    candidates_.erase(robot);
    return;
  }
  if (before != candidates_.end() && are_similar(before->second, fit)) {
    candidates_.erase(robot);
    if (!is_negligible(robots_.pose(robot).position_m, fit))
      transform_blocks(joint_, robot_and_seen_alone(robot), fit);
    return;
  }
  candidates_[robot] = fit;
}

std::vector<JointGaussian::Block> LandmarkMerger::robot_and_seen_alone(
    const std::string& robot) const {
  std::vector<JointGaussian::Block> blocks{robots_.block(robot)};
  for (const auto& landmark : landmarks_.all())
    if (landmark.seen_by.size() == 1 && landmark.was_seen_by(robot))
      blocks.push_back(landmark.block);
  return blocks;
}

}  // namespace galilean::monitor
