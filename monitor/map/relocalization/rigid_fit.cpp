#include "monitor/map/relocalization/rigid_fit.h"

#include <mrpt/math/TPose2D.h>
#include <mrpt/tfest/TMatchingPair.h>
#include <mrpt/tfest/se2.h>

#include <algorithm>
#include <cmath>

#include "monitor/map/estimation/gaussian.h"

namespace galilean::monitor {
namespace {

constexpr double kMostDeviations = 3;

bool exclude_one_another(const PointPair& a, const PointPair& b) {
  return a.map_index == b.map_index || a.other_index == b.other_index;
}

/// Of a transformation: what it does is reckoned once, for many points.
class Errors {
 public:
  explicit Errors(const Pose2& by)
      : turn_(rotation_by(by.heading_rad)), position_m_(by.position_m) {}

  [[nodiscard]] double squared_m2(const PointPair& pair) const {
    return (position_m_ + turn_ * pair.in_other_m - pair.in_map_m).squaredNorm();
  }

 private:
  Mat2 turn_;
  Vec2 position_m_;
};

/// Those that agree within so much, the nearest first; each point once. Nothing if they cannot be
/// more than `at_least`.
std::vector<PointPair> agreeing_with(const Pose2& by, const std::vector<PointPair>& pairs,
                                     double within_m, std::size_t at_least = 0) {
  struct Near {
    double squared_m2;
    const PointPair* pair;
  };
  const Errors errors(by);
  std::vector<Near> near;
  for (const auto& pair : pairs)
    if (const double error = errors.squared_m2(pair); error < within_m * within_m)
      near.push_back({error, &pair});
  std::vector<PointPair> once;
  if (near.size() <= at_least) return once;
  std::ranges::stable_sort(near, {}, &Near::squared_m2);
  for (const Near& each : near)
    if (std::ranges::none_of(
            once, [&](const PointPair& other) { return exclude_one_another(*each.pair, other); }))
      once.push_back(*each.pair);
  return once;
}

bool are_as_far_apart(const PointPair& a, const PointPair& b, double deviation_m) {
  if (exclude_one_another(a, b)) return false;
  const double here_m = (a.in_map_m - b.in_map_m).norm();
  const double there_m = (a.in_other_m - b.in_other_m).norm();
  return here_m > kMostDeviations * deviation_m &&
         std::abs(here_m - there_m) < kMostDeviations * deviation_m;
}

}  // namespace

double spread_of(const std::vector<PointPair>& pairs) {
  double spread_m = 0;
  for (const auto& a : pairs)
    for (const auto& b : pairs) spread_m = std::max(spread_m, (a.in_other_m - b.in_other_m).norm());
  return spread_m;
}

Pose2 laid_on(const Vec2& a, const Vec2& b, const Vec2& on_a, const Vec2& on_b) {
  const Vec2 from = b - a, to = on_b - on_a;
  const double turn_rad = wrap_angle(std::atan2(to.y(), to.x()) - std::atan2(from.y(), from.x()));
  return {(on_a + on_b) / 2 - rotated((a + b) / 2, turn_rad), turn_rad};
}

Pose2 least_squares(const std::vector<PointPair>& pairs) {
  mrpt::tfest::TMatchingPairList list;
  for (const auto& pair : pairs)
    list.emplace_back(
        static_cast<std::uint32_t>(pair.map_index), static_cast<std::uint32_t>(pair.other_index),
        static_cast<float>(pair.in_map_m.x()), static_cast<float>(pair.in_map_m.y()), 0.0F,
        static_cast<float>(pair.in_other_m.x()), static_cast<float>(pair.in_other_m.y()), 0.0F);
  mrpt::math::TPose2D best;
  mrpt::tfest::se2_l2(list, best);
  return {{best.x, best.y}, wrap_angle(best.phi)};
}

RigidFit fit_rigidly(const std::vector<PointPair>& pairs, double deviation_m, std::size_t least) {
  const double within_m = kMostDeviations * deviation_m;
  std::vector<PointPair> best;
  for (std::size_t i = 0; i < pairs.size(); ++i)
    for (std::size_t j = i + 1; j < pairs.size(); ++j) {
      const PointPair &a = pairs[i], &b = pairs[j];
      if (!are_as_far_apart(a, b, deviation_m)) continue;
      const Pose2 by = laid_on(a.in_other_m, b.in_other_m, a.in_map_m, b.in_map_m);
      if (auto all = agreeing_with(by, pairs, within_m, best.size()); all.size() > best.size())
        best = std::move(all);
    }
  RigidFit fit;
  if (best.size() < std::max<std::size_t>(least, 2)) return fit;
  fit.transform = least_squares(best);
  fit.agreeing = agreeing_with(fit.transform, pairs, within_m);
  if (fit.agreeing.size() < least) fit.agreeing.clear();
  fit.spread_m = spread_of(fit.agreeing);
  return fit;
}

}  // namespace galilean::monitor
