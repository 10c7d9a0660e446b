#pragma once

#include <vector>

#include "core/geometry.h"

namespace galilean::monitor {

/// The same point in two frames.
struct PointPair {
  Vec2 in_map_m;
  Vec2 in_other_m;
  std::size_t map_index = 0;  ///< pairs that share an index exclude one another
  std::size_t other_index = 0;
};

/// The rigid transformation that a set of pairs agrees on: p_map = position + R(heading) p_other.
struct RigidFit {
  Pose2 transform;
  std::vector<PointPair> agreeing;
  double spread_m = 0;  ///< of the agreeing pairs: the largest distance between two

  [[nodiscard]] Vec2 to_map(const Vec2& in_other_m) const {
    return transform.position_m + rotated(in_other_m, transform.heading_rad);
  }
};

/// The largest distance between two of them, in the other frame.
[[nodiscard]] double spread_of(const std::vector<PointPair>& pairs);

/// Lays point a on one and turns b about it as near to the other as it comes.
[[nodiscard]] Pose2 laid_on(const Vec2& a, const Vec2& b, const Vec2& on_a, const Vec2& on_b);

/// The best in the sense of least squares (mrpt::tfest::se2_l2). At least two pairs.
[[nodiscard]] Pose2 least_squares(const std::vector<PointPair>& pairs);

/// The transformation that most pairs agree on, false pairs and all.
///   law     every two pairs that are as far apart in both frames are laid on one another; that on
///           which most agree within kMostDeviations is refined by least squares. No draws by lot,
///           as mrpt::tfest::se2_l2_robust makes them: the same pairs give the same fit
///   units   `deviation_m`: of a point. `agreeing` is empty where fewer than `least` do
[[nodiscard]] RigidFit fit_rigidly(const std::vector<PointPair>& pairs, double deviation_m,
                                   std::size_t least);

}  // namespace galilean::monitor
