#include "monitor/map/groups/neighbours.h"

#include <algorithm>

#include "monitor/map/relocalization/transport.h"

namespace galilean::monitor {
namespace {

constexpr double kFarBetter = 2;  ///< variances
/// What another squad says is never believed to be surer than this: else two that tell one another
/// the same would each time be surer of it.
constexpr double kHearsay_m = 0.05;
/// A piece that lies so far from where another squad knows it was rather pushed since.
constexpr double kPushedDistance = 4;
/// Narrow, where all pairs are tried: two dozen landmarks in a room agree by chance otherwise.
constexpr double kFoundDeviation_m = 0.06;
constexpr double kLeastFoundSpread_m = 0.8;
/// Pairs of pairs are tried.
constexpr std::size_t kMostOwn = 24, kMostKnown = 48;

void teach(const ToldThing& knows, const ToldThing& learns) {
  const Mat2 hearsay = knows.place.covariance_m2 + kHearsay_m * kHearsay_m * Mat2::Identity();
  if (learns.place.covariance_m2.trace() < kFarBetter * hearsay.trace()) return;
  const auto& [squad, id] = learns.notes.front();
  const auto landmark = std::ranges::find(squad->landmarks.all(), id, &Landmark::id);
  const JointGaussian::Term itself[] = {{landmark->part, Mat2::Identity()}};
  const Vec2 apart = knows.place.mean_m - squad->joint.position(landmark->part);
  squad->joint.correct(itself, apart, hearsay);
}

/// Of those that it saw well, so many.
std::vector<Mark> own_marks(const Squad& squad) {
  std::vector<Mark> marks;
  for (const auto& landmark : squad.landmarks.all())
    if (landmark.is_confirmed() && landmark.object_class != "obstacle" && marks.size() < kMostOwn)
      marks.push_back(
          {squad.joint.position(landmark.part), mark_kind(landmark.object_class), landmark.id});
  return marks;
}

/// Of a large map, what is nearest to where the squad is believed to be.
std::vector<Mark> marks_of_others(const Squad& squad, const std::vector<ToldThing>& told) {
  auto marks = known_to_others(squad, told);
  const Vec2 centre_m = squad.extent_m.center();
  std::ranges::stable_sort(
      marks, {}, [&](const Mark& mark) { return (mark.in_map_m - centre_m).squaredNorm(); });
  marks.resize(std::min(marks.size(), kMostKnown));
  return marks;
}

std::vector<PointPair> all_pairs(const Squad& squad, const std::vector<ToldThing>& told) {
  const auto known = marks_of_others(squad, told);
  std::vector<PointPair> pairs;
  for (const Mark& own : own_marks(squad))
    for (const Mark& other : known)
      if (own.kind == other.kind) pairs.push_back({other.in_map_m, own.in_map_m, other.id, own.id});
  return pairs;
}

std::vector<JointGaussian::Part> parts_of(const Squad& squad) {
  std::vector<JointGaussian::Part> parts;
  for (const auto& [name, robot] : squad.poses.all()) parts.push_back(robot.part);
  for (const auto& landmark : squad.landmarks.all()) parts.push_back(landmark.part);
  return parts;
}

}  // namespace

void Neighbours::teach(const std::vector<ToldThing>& notes, const std::vector<SamePair>& pairs) {
  for (const auto& pair : pairs) {
    const ToldThing &a = notes[pair.a], &b = notes[pair.b];
    const bool may_have_moved =
        a.object_class == "trash" && pair.squared_distance > kPushedDistance;
    if (!pair.is_sure || may_have_moved || a.object_class == "obstacle") continue;
    const bool a_knows = a.place.covariance_m2.trace() < b.place.covariance_m2.trace();
    monitor::teach(a_knows ? a : b, a_knows ? b : a);
  }
}

void Neighbours::find_unplaced(const std::vector<ToldThing>& told) {
  Squad& squad = *squads_.all()[next_++ % squads_.all().size()];
  if (!squad.placed) find(squad, told);
}

void Neighbours::find(Squad& squad, const std::vector<ToldThing>& told) {
  const auto fit = fit_rigidly(all_pairs(squad, told), kFoundDeviation_m, kLeastAgreeing);
  const auto before = candidates_.find(&squad);
  const bool again = before != candidates_.end() && are_near(before->second, fit);
  candidates_.erase(&squad);
  if (fit.agreeing.empty() || fit.spread_m < kLeastFoundSpread_m) return;
  if (!again) {
    candidates_[&squad] = fit;
    return;
  }
  transport(squad.joint, parts_of(squad), fit);
  squad.placed = true;
}

}  // namespace galilean::monitor
