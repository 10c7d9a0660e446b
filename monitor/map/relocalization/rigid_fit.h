// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "core/geometry.h"

namespace galilean::monitor {

/// One point in two frames: the map frame and another.
struct Correspondence {
  Vec2 in_map_m;
  Vec2 in_other_m;
  std::size_t map_index = 0;  ///< correspondences that share an index exclude one another
  std::size_t other_index = 0;
};

/// The rigid transformation that a set of correspondences agrees on:
/// p_map = position + R(heading) p_other.
struct RigidFit {
  Pose2 transform;
  std::vector<Correspondence> agreeing;
  double spread_m = 0;  ///< largest distance between two of the agreeing points

  [[nodiscard]] Vec2 to_map(const Vec2& in_other_m) const {
    return transform.position_m + rotated(in_other_m, transform.heading_rad);
  }
};

/// Returns the largest distance between two of the points in the other frame [m].
[[nodiscard]] double spread_of(const std::vector<Correspondence>& correspondences);

/// Returns the transformation that lays segment a-b on segment on_a-on_b: their middles coincide,
/// and so do their directions.
[[nodiscard]] Pose2 align_segments(const Vec2& a, const Vec2& b, const Vec2& on_a,
                                   const Vec2& on_b);

/// Returns the transformation with the least sum of squared distances (mrpt::tfest::se2_l2).
/// Requires: at least two correspondences.
[[nodiscard]] Pose2 least_squares_fit(const std::vector<Correspondence>& correspondences);

/// Returns the transformation that most correspondences agree on, although many may be false.
///   law     Every two correspondences that are as far apart in both frames give a hypothesis. The
///           one on which most agree within three times `deviation_m` is refined by least squares.
///           All pairs are tried, where mrpt::tfest::se2_l2_robust draws them at random, so that
///           the same correspondences always give the same fit
///   units   `deviation_m` is the standard deviation of a point
/// Errors: `agreeing` is empty where fewer than `least` correspondences agree.
[[nodiscard]] RigidFit fit_rigid_transform(const std::vector<Correspondence>& correspondences,
                                           double deviation_m, std::size_t least);

}  // namespace galilean::monitor
