#pragma once

#include <Eigen/Core>
#include <vector>

#include "core/geometry.h"

namespace galilean::monitor {

using Mat3 = Eigen::Matrix3d;

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
  Mat3 covariance = Mat3::Zero();  ///< of (x, y, heading), m² and rad²
  std::vector<PointPair> agreeing;
  double spread_m = 0;  ///< of the agreeing pairs: the largest distance between two

  [[nodiscard]] Vec2 to_map(const Vec2& in_other_m) const {
    return transform.position_m + rotated(in_other_m, transform.heading_rad);
  }
};

/// The largest distance between two of them, in the other frame.
[[nodiscard]] double spread_of(const std::vector<PointPair>& pairs);

/// The transformation that most pairs agree on, false pairs and all (mrpt::tfest::se2_l2_robust).
/// `deviation_m`: of a point. `agreeing` is empty where fewer than `least` do.
[[nodiscard]] RigidFit fit_rigidly(const std::vector<PointPair>& pairs, double deviation_m,
                                   std::size_t least);

}  // namespace galilean::monitor
