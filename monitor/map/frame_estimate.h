#pragma once

#include <Eigen/Core>
#include <vector>

#include "core/geometry.h"
#include "monitor/map/gaussian.h"

namespace galilean::monitor {

using Mat3 = Eigen::Matrix3d;

/// Where a robot's odom frame lies in the map frame: p_map = position + R(heading) p_odom, and the
/// covariance of (x, y, heading) in m² and rad².
struct FrameEstimate {
  Pose2 pose;
  Mat3 covariance = Mat3::Zero();

  [[nodiscard]] Vec2 to_map(const Vec2& in_odom_m) const;
  /// With what is not known of the frame added to what is not known of the place.
  [[nodiscard]] Gaussian2 to_map(const Gaussian2& in_odom) const;
  [[nodiscard]] Pose2 to_map(const Pose2& in_odom) const;
  [[nodiscard]] Vec2 to_odom(const Vec2& in_map_m) const;
  /// Covariance of the position of a point that is fixed in the odom frame.
  [[nodiscard]] Mat2 covariance_at(const Vec2& in_odom_m) const;
};

/// The same point in two frames.
struct PointPair {
  Vec2 in_map_m;
  Vec2 in_odom_m;
  std::size_t map_index = 0;  ///< pairs that share an index exclude one another
  std::size_t odom_index = 0;
};

/// What a set of pairs says of a frame.
struct FrameFit {
  FrameEstimate frame;
  std::size_t agreeing = 0;  ///< pairs that it explains
  double spread_m = 0;       ///< of those pairs: the largest distance between two
};

/// The rigid transformation that most pairs agree on (mrpt::tfest::se2_l2_robust), false pairs and
/// all. `deviation_m`: of a point. No result, `agreeing` = 0, where fewer than `least` agree.
[[nodiscard]] FrameFit fit_frame(const std::vector<PointPair>& pairs, double deviation_m,
                                 std::size_t least);

/// The Kalman update of `estimate` by a fit.
[[nodiscard]] FrameEstimate corrected(const FrameEstimate& estimate, const FrameEstimate& fit);
/// Squared Mahalanobis distance between two estimates of a frame.
[[nodiscard]] double squared_distance(const FrameEstimate& a, const FrameEstimate& b);

}  // namespace galilean::monitor
