// SPDX-License-Identifier: BSD-3-Clause
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

bool exclude_one_another(const Correspondence& a, const Correspondence& b) {
  return a.map_index == b.map_index || a.other_index == b.other_index;
}

/// Computes the errors of a transformation. Its rotation matrix is computed once for many points.
class Errors {
 public:
  explicit Errors(const Pose2& by)
      : turn_(rotation_matrix(by.heading_rad)), position_m_(by.position_m) {}

  [[nodiscard]] double squared_m2(const Correspondence& pair) const {
    return (position_m_ + turn_ * pair.in_other_m - pair.in_map_m).squaredNorm();
  }

 private:
  Mat2 turn_;
  Vec2 position_m_;
};

/// Returns the correspondences that agree within `within_m`, the nearest first and each point once.
/// Returns none if no more than `at_least` can agree.
std::vector<Correspondence> agreeing_with(const Pose2& by,
                                          const std::vector<Correspondence>& correspondences,
                                          double within_m, std::size_t at_least = 0) {
  struct Near {
    double squared_m2;
    const Correspondence* pair;
  };
  const Errors errors(by);
  std::vector<Near> near;
  for (const auto& pair : correspondences)
    if (const double error = errors.squared_m2(pair); error < within_m * within_m)
      near.push_back({error, &pair});
  std::vector<Correspondence> once;
  if (near.size() <= at_least) return once;
  std::ranges::stable_sort(near, {}, &Near::squared_m2);
  for (const Near& each : near)
    if (std::ranges::none_of(once, [&](const Correspondence& other) {
          return exclude_one_another(*each.pair, other);
        }))
      once.push_back(*each.pair);
  return once;
}

bool are_as_far_apart(const Correspondence& a, const Correspondence& b, double deviation_m) {
  if (exclude_one_another(a, b)) return false;
  const double here_m = (a.in_map_m - b.in_map_m).norm();
  const double there_m = (a.in_other_m - b.in_other_m).norm();
  return here_m > kMostDeviations * deviation_m &&
         std::abs(here_m - there_m) < kMostDeviations * deviation_m;
}

}  // namespace

double spread_of(const std::vector<Correspondence>& correspondences) {
  double spread_m = 0;
  for (const auto& a : correspondences)
    for (const auto& b : correspondences)
      spread_m = std::max(spread_m, (a.in_other_m - b.in_other_m).norm());
  return spread_m;
}

Pose2 align_segments(const Vec2& a, const Vec2& b, const Vec2& on_a, const Vec2& on_b) {
  const Vec2 from = b - a, to = on_b - on_a;
  const double turn_rad = wrap_angle(std::atan2(to.y(), to.x()) - std::atan2(from.y(), from.x()));
  return {(on_a + on_b) / 2 - rotated((a + b) / 2, turn_rad), turn_rad};
}

Pose2 least_squares_fit(const std::vector<Correspondence>& correspondences) {
  mrpt::tfest::TMatchingPairList list;
  for (const auto& pair : correspondences)
    list.emplace_back(
        static_cast<std::uint32_t>(pair.map_index), static_cast<std::uint32_t>(pair.other_index),
        static_cast<float>(pair.in_map_m.x()), static_cast<float>(pair.in_map_m.y()), 0.0F,
        static_cast<float>(pair.in_other_m.x()), static_cast<float>(pair.in_other_m.y()), 0.0F);
  mrpt::math::TPose2D best;
  mrpt::tfest::se2_l2(list, best);
  return {{best.x, best.y}, wrap_angle(best.phi)};
}

RigidFit fit_rigid_transform(const std::vector<Correspondence>& correspondences, double deviation_m,
                             std::size_t least) {
  const double within_m = kMostDeviations * deviation_m;
  std::vector<Correspondence> best;
  for (std::size_t i = 0; i < correspondences.size(); ++i)
    for (std::size_t j = i + 1; j < correspondences.size(); ++j) {
      const Correspondence &a = correspondences[i], &b = correspondences[j];
      if (!are_as_far_apart(a, b, deviation_m)) continue;
      const Pose2 by = align_segments(a.in_other_m, b.in_other_m, a.in_map_m, b.in_map_m);
      if (auto all = agreeing_with(by, correspondences, within_m, best.size());
          all.size() > best.size())
        best = std::move(all);
    }
  RigidFit fit;
  if (best.size() < std::max<std::size_t>(least, 2)) return fit;
  fit.transform = least_squares_fit(best);
  fit.agreeing = agreeing_with(fit.transform, correspondences, within_m);
  if (fit.agreeing.size() < least) fit.agreeing.clear();
  fit.spread_m = spread_of(fit.agreeing);
  return fit;
}

}  // namespace galilean::monitor
