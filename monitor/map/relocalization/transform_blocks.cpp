// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/map/relocalization/transform_blocks.h"

#include <cmath>

#include "monitor/map/estimation/gaussian.h"

namespace galilean::monitor {
namespace {

constexpr double kTransported_m = 0.10, kTransported_rad = 0.05;
constexpr double kAlreadyThere_m = 0.5, kAlreadyThere_rad = 0.2;

}  // namespace

void transform_blocks(JointGaussian& joint, const std::vector<JointGaussian::Block>& blocks,
                      const RigidFit& fit) {
  std::vector<JointGaussian::Term> moved;
  const Mat2 turn = rotation_matrix(fit.transform.heading_rad);
  for (const JointGaussian::Block block : blocks) {
    JointGaussian::Vector mean = joint.mean(block);
    JointGaussian::Matrix jacobian = JointGaussian::Matrix::Identity(mean.size(), mean.size());
    jacobian.topLeftCorner<2, 2>() = turn;
    mean.head<2>() = fit.to_map(mean.head<2>());
    if (mean.size() > 2) mean[2] += fit.transform.heading_rad;
    joint.transform(block, mean, jacobian, JointGaussian::Matrix::Zero(mean.size(), mean.size()));
    const Vec2 arm = mean.head<2>() - fit.transform.position_m;
    JointGaussian::Matrix shared = JointGaussian::Matrix::Zero(mean.size(), 3);
    shared.topLeftCorner<2, 2>().setIdentity();
    shared.col(2).head<2>() << -arm.y(), arm.x();
    if (mean.size() > 2) shared(2, 2) = 1;
    moved.push_back({block, shared});
  }
  const Eigen::Vector3d deviations(kTransported_m, kTransported_m, kTransported_rad);
  joint.inflate(moved, JointGaussian::Matrix(deviations.cwiseAbs2().asDiagonal()));
}

bool is_negligible(const Vec2& robot_m, const RigidFit& fit) {
  return (fit.to_map(robot_m) - robot_m).norm() < kAlreadyThere_m &&
         std::abs(fit.transform.heading_rad) < kAlreadyThere_rad;
}

bool are_similar(const RigidFit& a, const RigidFit& b) {
  return (a.transform.position_m - b.transform.position_m).norm() < 0.3 &&
         std::abs(wrap_angle(a.transform.heading_rad - b.transform.heading_rad)) < 0.1;
}

}  // namespace galilean::monitor
