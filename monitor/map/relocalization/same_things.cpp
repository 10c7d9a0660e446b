#include "monitor/map/relocalization/same_things.h"

#include <Eigen/LU>
#include <algorithm>

#include "monitor/map/relocalization/transport.h"

namespace galilean::monitor {
namespace {

constexpr double kWellKnown_m = 0.10;   ///< standard deviation of a distance
constexpr double kNeighbours_m = 0.30;  ///< landmarks that two robots saw, if nearer, may be one
constexpr double kTwins_m = 0.12;       ///< landmarks that one robot saw, likewise
constexpr double kMatchedWithin_m = 1.2;
constexpr double kPointDeviation_m = 0.08;
/// Narrower where all pairs are tried: two dozen landmarks in a room agree by chance otherwise.
constexpr double kSearchDeviation_m = 0.06;
constexpr double kLeastSpread_m = 0.8;

bool share_an_observer(const Landmark& a, const Landmark& b) {
  return std::ranges::any_of(a.seen_by,
                             [&](const auto& seen) { return b.was_seen_by(seen.first); });
}

std::array<JointGaussian::Term, 2> difference(const Landmark& a, const Landmark& b) {
  return {{{a.part, Mat2::Identity()}, {b.part, -Mat2::Identity()}}};
}

}  // namespace

void SameThings::merge_neighbours() {
  while (const auto pair = nearest_neighbours()) landmarks_.merge(pair->kept, pair->same);
}

std::optional<SameThings::Pair> SameThings::nearest_neighbours() const {
  std::optional<Pair> best;
  const auto& all = landmarks_.all();
  for (std::size_t i = 0; i < all.size(); ++i)
    for (std::size_t j = i + 1; j < all.size(); ++j) {
      const Vec2 apart = joint_.position(all[i].part) - joint_.position(all[j].part);
      if (apart.norm() > kNeighbours_m || !may_be_same(all[i], all[j])) continue;
      const double within_m = share_an_observer(all[i], all[j]) ? kTwins_m : kNeighbours_m;
      if (apart.norm() > within_m) continue;
      const Mat2 covariance = joint_.covariance(difference(all[i], all[j]));
      if (covariance.trace() > 2 * kWellKnown_m * kWellKnown_m) continue;
      const double distance = apart.dot(covariance.inverse() * apart);
      if (distance < same_thing_gate() && (!best || distance < best->squared_distance))
        best = Pair{std::min(all[i].id, all[j].id), std::max(all[i].id, all[j].id), distance};
    }
  return best;
}

void SameThings::align(Time now, const std::vector<Mark>& others_know) {
  now_ = now;
  const auto& robots = robots_.all();
  if (robots.empty()) return;
  auto next = robots.upper_bound(last_aligned_);
  if (next == robots.end()) next = robots.begin();
  last_aligned_ = next->first;
  merge_agreeing(next->first);
  lost_.lay_back(next->first, now, others_know);
  if (next != robots.begin() && !shares_landmarks(next->first)) search(next->first);
}

std::vector<PointPair> SameThings::pairs(const std::string& robot, bool inside_gate) const {
  std::vector<PointPair> result;
  const auto& all = landmarks_.all();
  const Time since = inside_gate ? now_ - Landmark::kObservationWindow : Time::min();
  for (const auto& own : all) {
    if (!own.is_confirmed() || !own.was_seen_by(robot, since)) continue;
    for (const auto& other : all) {
      if (!other.is_confirmed() || other.was_seen_by(robot, since) || !may_be_same(own, other))
        continue;
      const Vec2 own_m = joint_.position(own.part), other_m = joint_.position(other.part);
      if (inside_gate) {
        const Vec2 apart = own_m - other_m;
        if (apart.norm() > kMatchedWithin_m) continue;
        const Mat2 covariance = joint_.covariance(difference(own, other)) +
                                kPointDeviation_m * kPointDeviation_m * Mat2::Identity();
        if (apart.dot(covariance.inverse() * apart) > same_thing_gate()) continue;
      }
      result.push_back({other_m, own_m, other.id, own.id});
    }
  }
  return result;
}

void SameThings::merge_agreeing(const std::string& robot) {
  const auto fit = fit_rigidly(pairs(robot, true), kPointDeviation_m, kLeastAgreeing);
  if (fit.agreeing.empty() || fit.spread_m < kLeastSpread_m) return;
  for (const auto& pair : fit.agreeing)
    landmarks_.merge(std::min(pair.map_index, pair.other_index),
                     std::max(pair.map_index, pair.other_index));
}

bool SameThings::shares_landmarks(const std::string& robot) const {
  return std::ranges::any_of(landmarks_.all(), [&](const Landmark& landmark) {
    return landmark.seen_by.size() > 1 && landmark.was_seen_by(robot);
  });
}

void SameThings::search(const std::string& robot) {
  const auto all = pairs(robot, false);
  const auto fit = fit_rigidly(all, kSearchDeviation_m, kLeastForUnknown);
  const auto before = candidates_.find(robot);
  if (fit.agreeing.empty() || fit.spread_m < kLeastSpread_m) {
    candidates_.erase(robot);
    return;
  }
  if (before != candidates_.end() && are_near(before->second, fit)) {
    candidates_.erase(robot);
    if (!is_there_already(robots_.pose(robot).position_m, fit))
      transport(joint_, robot_and_seen_alone(robot), fit);
    return;
  }
  candidates_[robot] = fit;
}

std::vector<JointGaussian::Part> SameThings::robot_and_seen_alone(const std::string& robot) const {
  std::vector<JointGaussian::Part> parts{robots_.part(robot)};
  for (const auto& landmark : landmarks_.all())
    if (landmark.seen_by.size() == 1 && landmark.was_seen_by(robot)) parts.push_back(landmark.part);
  return parts;
}

}  // namespace galilean::monitor
