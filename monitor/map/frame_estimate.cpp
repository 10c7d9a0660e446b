#include "monitor/map/frame_estimate.h"

#include <mrpt/poses/CPosePDFSOG.h>
#include <mrpt/tfest/TMatchingPair.h>
#include <mrpt/tfest/se2.h>

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <algorithm>

namespace galilean::monitor {
namespace {

using Vec3 = Eigen::Vector3d;

mrpt::tfest::TMatchingPairList to_mrpt(const std::vector<PointPair>& pairs) {
  mrpt::tfest::TMatchingPairList list;
  for (const auto& pair : pairs)
    list.emplace_back(
        static_cast<std::uint32_t>(pair.map_index), static_cast<std::uint32_t>(pair.odom_index),
        static_cast<float>(pair.in_map_m.x()), static_cast<float>(pair.in_map_m.y()), 0.0F,
        static_cast<float>(pair.in_odom_m.x()), static_cast<float>(pair.in_odom_m.y()), 0.0F);
  return list;
}

double spread_of(const mrpt::tfest::TMatchingPairList& pairs) {
  double spread_m = 0;
  for (const auto& a : pairs)
    for (const auto& b : pairs) spread_m = std::max<double>(spread_m, (a.local - b.local).norm());
  return spread_m;
}

Vec3 difference(const FrameEstimate& a, const FrameEstimate& b) {
  const Vec2 position = a.pose.position_m - b.pose.position_m;
  return {position.x(), position.y(), wrap_angle(a.pose.heading_rad - b.pose.heading_rad)};
}

}  // namespace

Vec2 FrameEstimate::to_map(const Vec2& in_odom_m) const {
  return pose.position_m + rotated(in_odom_m, pose.heading_rad);
}

Pose2 FrameEstimate::to_map(const Pose2& in_odom) const {
  return {to_map(in_odom.position_m), wrap_angle(pose.heading_rad + in_odom.heading_rad)};
}

Vec2 FrameEstimate::to_odom(const Vec2& in_map_m) const {
  return rotated(in_map_m - pose.position_m, -pose.heading_rad);
}

Mat2 FrameEstimate::covariance_at(const Vec2& in_odom_m) const {
  const Vec2 turned = rotated(in_odom_m, pose.heading_rad);
  Eigen::Matrix<double, 2, 3> jacobian;
  jacobian << 1, 0, -turned.y(), 0, 1, turned.x();
  return jacobian * covariance * jacobian.transpose();
}

Gaussian2 FrameEstimate::to_map(const Gaussian2& in_odom) const {
  const Vec2 x = unit_vector(pose.heading_rad);
  Mat2 rotation;
  rotation << x.x(), -x.y(), x.y(), x.x();
  return {to_map(in_odom.mean_m),
          rotation * in_odom.covariance_m2 * rotation.transpose() + covariance_at(in_odom.mean_m)};
}

FrameFit fit_frame(const std::vector<PointPair>& pairs, double deviation_m, std::size_t least) {
  FrameFit fit;
  if (pairs.size() < std::max<std::size_t>(least, 2)) return fit;
  mrpt::tfest::TSE2RobustParams parameters;
  parameters.ransac_minSetSize = static_cast<unsigned>(least);
  parameters.ransac_maxSetSize = static_cast<unsigned>(pairs.size());
  parameters.ransac_min_nSimulations = 300;
  mrpt::tfest::TSE2RobustResult result;
  if (!mrpt::tfest::se2_l2_robust(to_mrpt(pairs), deviation_m, parameters, result)) return fit;
  if (result.largestSubSet.size() < least || result.transformation.empty()) return fit;

  const auto& modes = result.transformation.getSOGModes();
  const auto best =
      std::ranges::max_element(modes, {}, [](const auto& mode) { return mode.log_w; });
  fit.frame.pose = {{best->mean.x(), best->mean.y()}, wrap_angle(best->mean.phi())};
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column < 3; ++column)
      fit.frame.covariance(row, column) = best->cov(row, column);
  fit.agreeing = result.largestSubSet.size();
  fit.spread_m = spread_of(result.largestSubSet);
  return fit;
}

FrameEstimate corrected(const FrameEstimate& estimate, const FrameEstimate& fit) {
  const Mat3 sum = estimate.covariance + fit.covariance;
  const Mat3 gain = sum.ldlt().solve(estimate.covariance).transpose();
  const Vec3 step = gain * difference(fit, estimate);
  FrameEstimate result;
  result.pose = {estimate.pose.position_m + step.head<2>(),
                 wrap_angle(estimate.pose.heading_rad + step.z())};
  const Mat3 rest = Mat3::Identity() - gain;
  result.covariance =
      rest * estimate.covariance * rest.transpose() + gain * fit.covariance * gain.transpose();
  return result;
}

double squared_distance(const FrameEstimate& a, const FrameEstimate& b) {
  const Vec3 apart = difference(a, b);
  return apart.dot((a.covariance + b.covariance).inverse() * apart);
}

}  // namespace galilean::monitor
