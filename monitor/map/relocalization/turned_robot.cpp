#include "monitor/map/relocalization/turned_robot.h"

#include <algorithm>
#include <cmath>

#include "monitor/map/estimation/gaussian.h"

namespace galilean::monitor {
namespace {

constexpr double kSameLength_m = 0.12;
constexpr double kAgree_m = 0.15;
constexpr double kLeastApart_m = 0.4;  ///< of two marks that tell a turn
constexpr double kLeastTurnSpread_m = 0.8;
/// Of all that was seen, so much must be known: the rest may be new indeed.
constexpr double kLeastShare = 0.6;
/// So many fewer agree on any other turn.
constexpr std::size_t kLead = 2;
constexpr double kOtherTurn_rad = 0.2, kOtherShift_m = 0.35;

using Marks = std::vector<Mark>;

Vec2 laid_by(const Pose2& by, const Vec2& point_m) {
  return by.position_m + rotated(point_m, by.heading_rad);
}

bool is_same_turn(const Pose2& a, const Pose2& b, const Vec2& robot_m) {
  return std::abs(wrap_angle(a.heading_rad - b.heading_rad)) < kOtherTurn_rad &&
         (laid_by(a, robot_m) - laid_by(b, robot_m)).norm() < kOtherShift_m;
}

std::vector<PointPair> agreeing(const Marks& seen, const Marks& known, const Pose2& by) {
  const Mat2 turn = rotation_by(by.heading_rad);
  std::vector<PointPair> pairs;
  for (const Mark& mark : seen) {
    const Vec2 there_m = by.position_m + turn * mark.in_map_m;
    const Mark* nearest = nullptr;
    for (const Mark& other : known) {
      const double apart_m = (other.in_map_m - there_m).norm();
      if (apart_m >= kAgree_m || other.kind != mark.kind) continue;
      const bool taken = std::ranges::find(pairs, other.id, &PointPair::map_index) != pairs.end();
      if (!taken && (!nearest || apart_m < (nearest->in_map_m - there_m).norm())) nearest = &other;
    }
    if (nearest) pairs.push_back({nearest->in_map_m, mark.in_map_m, nearest->id, mark.id});
  }
  return pairs;
}

struct Hypothesis {
  Pose2 by;
  std::vector<PointPair> pairs;
};

std::vector<Hypothesis> hypotheses(const Marks& seen, const Marks& known, const Vec2& robot_m,
                                   double most_shift_m) {
  std::vector<Hypothesis> result;
  for (std::size_t i = 0; i < seen.size(); ++i)
    for (std::size_t j = i + 1; j < seen.size(); ++j) {
      const double length_m = (seen[i].in_map_m - seen[j].in_map_m).norm();
      if (length_m < kLeastApart_m) continue;
      for (const Mark& a : known)
        for (const Mark& b : known) {
          if (a.id == b.id || a.kind != seen[i].kind || b.kind != seen[j].kind) continue;
          if (std::abs((a.in_map_m - b.in_map_m).norm() - length_m) > kSameLength_m) continue;
          const Pose2 by = laid_on(seen[i].in_map_m, seen[j].in_map_m, a.in_map_m, b.in_map_m);
          if (std::abs(by.heading_rad) > TurnedRobot::kMostTurn_rad ||
              (laid_by(by, robot_m) - robot_m).norm() > most_shift_m)
            continue;
          result.push_back({by, agreeing(seen, known, by)});
        }
    }
  return result;
}

/// Those that something seen can lie on, however far the robot is turned and shifted.
Marks within_reach(const Marks& known, const Marks& seen, const Vec2& robot_m,
                   double most_shift_m) {
  double reach_m = 0;
  for (const Mark& mark : seen) reach_m = std::max(reach_m, (mark.in_map_m - robot_m).norm());
  reach_m += most_shift_m + kAgree_m + kSameLength_m;
  Marks result;
  for (const Mark& mark : known)
    if ((mark.in_map_m - robot_m).norm() < reach_m) result.push_back(mark);
  return result;
}

}  // namespace

std::size_t mark_kind(const std::string& object_class) {
  return std::hash<std::string>()(object_class);
}

std::optional<RigidFit> TurnedRobot::fit(const Marks& seen, const Marks& all_known,
                                         const Vec2& robot_m, double most_shift_m) {
  if (seen.size() < kLeastAgreeing) return std::nullopt;
  const Marks known = within_reach(all_known, seen, robot_m, most_shift_m);
  const auto all = hypotheses(seen, known, robot_m, most_shift_m);
  if (all.empty()) return std::nullopt;
  const auto& best =
      *std::ranges::max_element(all, {}, [](const Hypothesis& each) { return each.pairs.size(); });
  const std::size_t count = best.pairs.size();
  if (count < kLeastAgreeing ||
      static_cast<double>(count) < kLeastShare * static_cast<double>(seen.size()))
    return std::nullopt;
  const Pose2 by = least_squares(best.pairs);
  for (const auto& other : all)
    if (other.pairs.size() + kLead > count && !is_same_turn(other.by, by, robot_m))
      return std::nullopt;
  RigidFit fit{.transform = by, .agreeing = agreeing(seen, known, by)};
  fit.spread_m = spread_of(fit.agreeing);
  if (fit.agreeing.size() < kLeastAgreeing || fit.spread_m < kLeastTurnSpread_m)
    return std::nullopt;
  return fit;
}

}  // namespace galilean::monitor
