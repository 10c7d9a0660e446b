#include "monitor/map/same_things.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "monitor/map/transport.h"

namespace galilean::monitor {
namespace {

constexpr double kWellKnown_m = 0.10;   ///< standard deviation of a distance
constexpr double kNeighbours_m = 0.30;  ///< things that two robots saw, if nearer, may be one
constexpr double kTwins_m = 0.12;       ///< things that one robot saw, likewise
constexpr double kMatchedWithin_m = 1.2;
constexpr double kPointDeviation_m = 0.08;
/// Narrower where all pairs are tried: two dozen things in a room agree by chance otherwise.
constexpr double kSearchDeviation_m = 0.06;
/// A robot that lost its way sees anew what it knew before.
constexpr Duration kLately = std::chrono::seconds(10);
constexpr double kLeastSpread_m = 0.8;
constexpr double kAlreadyThere_m = 0.5, kAlreadyThere_rad = 0.2;

bool share_an_observer(const Thing& a, const Thing& b) {
  return std::ranges::any_of(a.seen_by,
                             [&](const auto& seen) { return b.was_seen_by(seen.first); });
}

std::array<JointGaussian::Term, 2> difference(const Thing& a, const Thing& b) {
  return {{{a.part, Mat2::Identity()}, {b.part, -Mat2::Identity()}}};
}

bool is_there_already(const Vec2& robot_m, const RigidFit& fit) {
  return (fit.to_map(robot_m) - robot_m).norm() < kAlreadyThere_m &&
         std::abs(fit.transform.heading_rad) < kAlreadyThere_rad;
}

}  // namespace

void SameThings::unite_neighbours() {
  while (const auto pair = nearest_neighbours()) things_.unite(pair->kept, pair->same);
}

std::optional<SameThings::Pair> SameThings::nearest_neighbours() const {
  std::optional<Pair> best;
  const auto& all = things_.all();
  for (std::size_t i = 0; i < all.size(); ++i)
    for (std::size_t j = i + 1; j < all.size(); ++j) {
      const Vec2 apart = joint_.position(all[i].part) - joint_.position(all[j].part);
      if (apart.norm() > kNeighbours_m || !may_be_one(all[i], all[j])) continue;
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
  unite_agreeing(next->first);
  if (recognises_nothing(next->first)) turn_back(next->first, others_know);
  rejoin(next->first, others_know);
  if (next != robots.begin() && !shares_things(next->first)) search(next->first);
}

std::vector<PointPair> SameThings::pairs(const std::string& robot, bool inside_gate) const {
  std::vector<PointPair> result;
  const auto& all = things_.all();
  const Time since = inside_gate ? now_ - kLately : Time::min();
  for (const auto& own : all) {
    if (!own.established() || !own.was_seen_by(robot, since)) continue;
    for (const auto& other : all) {
      if (!other.established() || other.was_seen_by(robot, since) || !may_be_one(own, other))
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

void SameThings::unite_agreeing(const std::string& robot) {
  const auto fit = fit_rigidly(pairs(robot, true), kPointDeviation_m, kLeastAgreeing);
  if (fit.agreeing.empty() || fit.spread_m < kLeastSpread_m) return;
  for (const auto& pair : fit.agreeing)
    things_.unite(std::min(pair.map_index, pair.other_index),
                  std::max(pair.map_index, pair.other_index));
}

bool SameThings::shares_things(const std::string& robot) const {
  return std::ranges::any_of(things_.all(), [&](const Thing& thing) {
    return thing.seen_by.size() > 1 && thing.was_seen_by(robot);
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
      transport(joint_, with(robot, seen_alone(robot)), fit);
    return;
  }
  candidates_[robot] = fit;
}

/// What stays where it is for a while, and was seen often enough.
std::vector<const Thing*> SameThings::landmarks() const {
  std::vector<const Thing*> result;
  for (const auto& thing : things_.all())
    if (thing.established() && thing.object_class != "obstacle") result.push_back(&thing);
  return result;
}

Mark SameThings::mark_of(const Thing& thing) const {
  return {joint_.position(thing.part), mark_kind(thing.object_class), thing.id};
}

/// Of what it saw lately, nearly all is new, and nobody else saw it.
bool SameThings::recognises_nothing(const std::string& robot) const {
  std::size_t fresh = 0, known = 0;
  for (const Thing* thing : landmarks())
    if (thing->was_seen_by(robot, now_ - kLately))
      ++(thing->is_new_of(robot, now_) ? fresh : known);
  return fresh >= TurnedRobot::kLeastAgreeing && fresh > 2 * known;
}

void SameThings::turn_back(const std::string& robot, const std::vector<Mark>& others_know) {
  std::vector<Mark> seen, known = others_know;
  std::vector<JointGaussian::Part> own;
  for (const Thing* thing : landmarks()) {
    if (thing->is_new_of(robot, now_)) {
      seen.push_back(mark_of(*thing));
      own.push_back(thing->part);
    } else if (!thing->was_seen_by(robot, now_ - kLately)) {
      known.push_back(mark_of(*thing));
    }
  }
  const Vec2 robot_m = robots_.pose(robot).position_m;
  const auto fit = TurnedRobot::fit(seen, known, robot_m);
  // What others know beside it is put right by what they tell, and needs no laying back.
  const bool needless = fit && !others_know.empty() && is_there_already(robot_m, *fit);
  if (fit && !needless) lay_back(robot, own, *fit);
}

void SameThings::rejoin(const std::string& robot, const std::vector<Mark>& others_know) {
  std::vector<Mark> seen, known = others_know;
  std::vector<JointGaussian::Part> own;
  for (const Thing* thing : landmarks()) {
    const bool lately = thing->was_seen_by(robot, now_ - kLately);
    const bool shared = thing->seen_by.size() > 1;
    if (lately) seen.push_back(mark_of(*thing));
    if (shared) known.push_back(mark_of(*thing));
    if (lately && !shared) own.push_back(thing->part);
  }
  const Vec2 robot_m = robots_.pose(robot).position_m;
  const auto fit = TurnedRobot::fit(seen, known, robot_m);
  if (fit && !is_there_already(robot_m, *fit)) lay_back(robot, own, *fit);
}

void SameThings::lay_back(const std::string& robot, const std::vector<JointGaussian::Part>& own,
                          const RigidFit& fit) {
  transport(joint_, with(robot, own), fit);
  for (const auto& pair : fit.agreeing) things_.unite(pair.map_index, pair.other_index);
}

std::vector<JointGaussian::Part> SameThings::with(const std::string& robot,
                                                  std::vector<JointGaussian::Part> things) const {
  things.insert(things.begin(), robots_.part(robot));
  return things;
}

std::vector<JointGaussian::Part> SameThings::seen_alone(const std::string& robot) const {
  std::vector<JointGaussian::Part> parts;
  for (const auto& thing : things_.all())
    if (thing.seen_by.size() == 1 && thing.was_seen_by(robot)) parts.push_back(thing.part);
  return parts;
}

}  // namespace galilean::monitor
