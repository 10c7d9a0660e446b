// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/map/relocalization/local_rigid_fit.h"

#include <algorithm>
#include <cmath>

#include "monitor/map/estimation/gaussian.h"

namespace galilean::monitor {
namespace {

constexpr double kSameLength_m = 0.12;
constexpr double kAgree_m = 0.15;
constexpr double kLeastApart_m = 0.4;  ///< two points that are nearer determine no turn
constexpr double kLeastTurnSpread_m = 0.8;
/// This share of the seen points must be known. The others may be new.
constexpr double kLeastShare = 0.6;
/// At least so many fewer points must agree on any other turn or shift.
constexpr std::size_t kLeadInPairs = 2;
constexpr double kOtherTurn_rad = 0.2, kOtherShift_m = 0.35;

using LabelledPoints = std::vector<LabelledPoint>;

Vec2 transformed(const Pose2& by, const Vec2& point_m) {
  return by.position_m + rotated(point_m, by.heading_rad);
}

bool is_same_turn(const Pose2& a, const Pose2& b, const Vec2& robot_m) {
  return std::abs(wrap_angle(a.heading_rad - b.heading_rad)) < kOtherTurn_rad &&
         (transformed(a, robot_m) - transformed(b, robot_m)).norm() < kOtherShift_m;
}

std::vector<Correspondence> agreeing(const LabelledPoints& seen, const LabelledPoints& known,
                                     const Pose2& by) {
  const Mat2 turn = rotation_matrix(by.heading_rad);
  std::vector<Correspondence> correspondences;
  for (const LabelledPoint& point : seen) {
    const Vec2 there_m = by.position_m + turn * point.position_m;
    const LabelledPoint* nearest = nullptr;
    for (const LabelledPoint& other : known) {
      const double apart_m = (other.position_m - there_m).norm();
      if (apart_m >= kAgree_m || other.label != point.label) continue;
      const bool taken = std::ranges::find(correspondences, other.id, &Correspondence::map_index) !=
                         correspondences.end();
      if (!taken && (!nearest || apart_m < (nearest->position_m - there_m).norm()))
        nearest = &other;
    }
    if (nearest)
      correspondences.push_back({nearest->position_m, point.position_m, nearest->id, point.id});
  }
  return correspondences;
}

struct Hypothesis {
  Pose2 by;
  std::vector<Correspondence> correspondences;
};

std::vector<Hypothesis> hypotheses(const LabelledPoints& seen, const LabelledPoints& known,
                                   const Vec2& robot_m, double max_shift_m) {
  std::vector<Hypothesis> result;
  for (std::size_t i = 0; i < seen.size(); ++i)
    for (std::size_t j = i + 1; j < seen.size(); ++j) {
      const double length_m = (seen[i].position_m - seen[j].position_m).norm();
      if (length_m < kLeastApart_m) continue;
      for (const LabelledPoint& a : known)
        for (const LabelledPoint& b : known) {
          if (a.id == b.id || a.label != seen[i].label || b.label != seen[j].label) continue;
          if (std::abs((a.position_m - b.position_m).norm() - length_m) > kSameLength_m) continue;
          const Pose2 by =
              align_segments(seen[i].position_m, seen[j].position_m, a.position_m, b.position_m);
          if (std::abs(by.heading_rad) > LocalRigidFit::kMaxTurn_rad ||
              (transformed(by, robot_m) - robot_m).norm() > max_shift_m)
            continue;
          result.push_back({by, agreeing(seen, known, by)});
        }
    }
  return result;
}

/// Returns the known points that a seen point can correspond to, for any turn and any shift of the
/// robot up to `max_shift_m`.
LabelledPoints within_reach(const LabelledPoints& known, const LabelledPoints& seen,
                            const Vec2& robot_m, double max_shift_m) {
  double reach_m = 0;
  for (const LabelledPoint& point : seen)
    reach_m = std::max(reach_m, (point.position_m - robot_m).norm());
  reach_m += max_shift_m + kAgree_m + kSameLength_m;
  LabelledPoints result;
  for (const LabelledPoint& point : known)
    if ((point.position_m - robot_m).norm() < reach_m) result.push_back(point);
  return result;
}

}  // namespace

std::optional<RigidFit> LocalRigidFit::find(const LabelledPoints& seen,
                                            const LabelledPoints& all_known, const Vec2& robot_m,
                                            double max_shift_m) {
  if (seen.size() < kLeastAgreeing) return std::nullopt;
  const LabelledPoints known = within_reach(all_known, seen, robot_m, max_shift_m);
  const auto all = hypotheses(seen, known, robot_m, max_shift_m);
  if (all.empty()) return std::nullopt;
  const auto& best = *std::ranges::max_element(
      all, {}, [](const Hypothesis& each) { return each.correspondences.size(); });
  const std::size_t count = best.correspondences.size();
  if (count < kLeastAgreeing ||
      static_cast<double>(count) < kLeastShare * static_cast<double>(seen.size()))
    return std::nullopt;
  const Pose2 by = least_squares_fit(best.correspondences);
  for (const auto& other : all)
    if (other.correspondences.size() + kLeadInPairs > count && !is_same_turn(other.by, by, robot_m))
      return std::nullopt;
  RigidFit fit{.transform = by, .agreeing = agreeing(seen, known, by)};
  fit.spread_m = spread_of(fit.agreeing);
  if (fit.agreeing.size() < kLeastAgreeing || fit.spread_m < kLeastTurnSpread_m)
    return std::nullopt;
  return fit;
}

}  // namespace galilean::monitor
