#include "monitor/map/frames.h"

#include <algorithm>
#include <functional>
#include <utility>

namespace galilean::monitor {
namespace {

constexpr double kDegree = kPi / 180;
constexpr double square(double value) {
  return value * value;
}

/// A start that somebody gave by hand, or that all robots share.
const Eigen::DiagonalMatrix<double, 3> kStartCovariance(square(0.15), square(0.15),
                                                        square(12 * kDegree));
/// The reference says where the map is.
const Eigen::DiagonalMatrix<double, 3> kReference(1e-6, 1e-6, 1e-6);
/// What dead reckoning loses in a second of driving.
const Eigen::DiagonalMatrix<double, 3> kDrift_ps(square(0.01), square(0.01), square(0.4 * kDegree));
/// Fits a second apart rest on much the same sightings: none is worth more than this.
const Eigen::DiagonalMatrix<double, 3> kFitFloor(square(0.08), square(0.08), square(2.0 * kDegree));

constexpr double kPointDeviation_m = 0.10;
/// Narrower where all pairs are tried: two dozen things in a room agree by chance otherwise.
constexpr double kSearchDeviation_m = 0.06;
constexpr double kLeastCertainty = 0.3;
constexpr double kLeastSpread_m = 0.8;
constexpr double kLongestDrift_s = 1.0;
constexpr double kUnfittedBeforeSearch_s = 5;
constexpr std::size_t kMostSearched = 12;  ///< landmarks of each side

constexpr double kEncounterMemory_s = 40;
constexpr double kEncounterStep_m = 0.15;
constexpr std::size_t kMostEncounters = 600;

std::vector<Landmark> surest(const RobotMemory& memory, std::size_t most) {
  std::vector<Landmark> result;
  for (const auto& landmark : memory.landmarks())
    if (landmark.certainty >= kLeastCertainty) result.push_back(landmark);
  std::ranges::sort(result, std::greater(), &Landmark::certainty);
  if (result.size() > most) result.resize(most);
  return result;
}

}  // namespace

void Frames::start_at(const std::string& robot, const Pose2& origin) {
  tracked(robot).estimate.pose = origin;
}

Frames::Tracked& Frames::tracked(const std::string& robot) {
  const auto [found, is_new] = frames_.try_emplace(robot);
  if (is_new) found->second.estimate.covariance = kStartCovariance;
  return found->second;
}

const FrameEstimate& Frames::of(const std::string& robot) {
  return tracked(robot).estimate;
}

void Frames::note(Encounter encounter) {
  const auto same_place = [&](const Encounter& other) {
    return other.observer == encounter.observer && other.observed == encounter.observed &&
           (other.in_observed_m - encounter.in_observed_m).norm() < kEncounterStep_m &&
           (other.in_observer_m - encounter.in_observer_m).norm() < kEncounterStep_m;
  };
  if (std::ranges::any_of(encounters_, same_place)) return;
  encounters_.push_back(std::move(encounter));
  if (encounters_.size() > kMostEncounters) encounters_.pop_front();
}

void Frames::align(const Memories& memories, Time now) {
  while (!encounters_.empty() && to_seconds(now - encounters_.front().at) > kEncounterMemory_s)
    encounters_.pop_front();
  const auto first = std::ranges::find_if(
      memories, [](const auto& each) { return !each.second.landmarks().empty(); });
  if (first == memories.end()) return;
  tracked(first->first).estimate.covariance = Mat3(kReference);
  // The first is the reference: all others in turn.
  auto next = memories.upper_bound(last_aligned_);
  if (next == memories.end()) next = memories.begin();
  if (next == first) ++next;
  if (next == memories.end()) next = memories.begin();
  last_aligned_ = next->first;
  if (next == first) return;
  correct(next->first, memories, now);
  if (to_seconds(now - tracked(next->first).fitted) > kUnfittedBeforeSearch_s)
    search(next->first, memories, now);
}

void Frames::correct(const std::string& robot, const Memories& memories, Time now) {
  Tracked& frame = tracked(robot);
  const double since_s = std::min(to_seconds(now - frame.drifted), kLongestDrift_s);
  frame.estimate.covariance += Mat3(kDrift_ps) * since_s;
  frame.drifted = now;
  auto fit = fit_frame(pairs(robot, memories, true), kPointDeviation_m, kLeastAgreeing);
  if (fit.agreeing < kLeastAgreeing || fit.spread_m < kLeastSpread_m) return;
  fit.frame.covariance += Mat3(kFitFloor);
  if (squared_distance(frame.estimate, fit.frame) > same_pose_gate()) return;
  frame.estimate = corrected(frame.estimate, fit.frame);
  frame.fitted = now;
}

void Frames::search(const std::string& robot, const Memories& memories, Time now) {
  Tracked& frame = tracked(robot);
  auto fit = fit_frame(pairs(robot, memories, false), kSearchDeviation_m, kLeastForUnknown);
  if (fit.agreeing < kLeastForUnknown || fit.spread_m < kLeastSpread_m) {
    frame.candidate.reset();
    return;
  }
  fit.frame.covariance += Mat3(kFitFloor);
  const auto before = std::exchange(frame.candidate, fit.frame);
  if (!before || squared_distance(*before, fit.frame) > same_pose_gate()) return;
  frame.estimate = fit.frame;
  frame.fitted = now;
  frame.candidate.reset();
}

std::vector<PointPair> Frames::pairs(const std::string& robot, const Memories& memories,
                                     bool inside_gate) {
  std::vector<PointPair> result;
  const std::size_t most = inside_gate ? 64 : kMostSearched;
  const auto own = surest(memories.at(robot), most);
  const FrameEstimate& frame = of(robot);
  std::size_t map_index = 0;
  for (const auto& [other, memory] : memories) {
    if (other == robot) continue;
    for (const auto& theirs : surest(memory, most)) {
      const auto in_map = of(other).to_map(theirs.place);
      for (std::size_t i = 0; i < own.size(); ++i) {
        if (own[i].object_class != theirs.object_class) continue;
        if (inside_gate &&
            squared_mahalanobis(frame.to_map(own[i].place), in_map) > same_thing_gate())
          continue;
        result.push_back({in_map.mean_m, own[i].place.mean_m, map_index, i});
      }
      ++map_index;
    }
  }
  add_encounters(robot, inside_gate, result);
  return result;
}

void Frames::add_encounters(const std::string& robot, bool inside_gate,
                            std::vector<PointPair>& pairs) {
  // Beyond the landmarks' indices: one a sighting on the side that saw, one an encounter on the
  // other, so that a sighting is of one robot and a robot at one place is seen once.
  constexpr std::size_t kFirst = 2048;
  if (encounters_.empty()) return;
  const auto oldest = encounters_.front().sighting;
  const FrameEstimate& frame = of(robot);
  for (std::size_t i = 0; i < encounters_.size(); ++i) {
    const Encounter& met = encounters_[i];
    const auto sighting = kFirst + (met.sighting - oldest);
    PointPair pair;
    if (met.observer == robot)
      pair = {of(met.observed).to_map(met.in_observed_m), met.in_observer_m, kFirst + i, sighting};
    else if (met.observed == robot)
      pair = {of(met.observer).to_map(met.in_observer_m), met.in_observed_m, sighting, kFirst + i};
    else
      continue;
    const Gaussian2 here{pair.in_odom_m, square(kPointDeviation_m) * Mat2::Identity()};
    const Gaussian2 there{pair.in_map_m, square(kPointDeviation_m) * Mat2::Identity()};
    if (!inside_gate || squared_mahalanobis(frame.to_map(here), there) < same_thing_gate())
      pairs.push_back(pair);
  }
}

}  // namespace galilean::monitor
