// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/map/estimation/joint_gaussian.h"

#include <gtest/gtest.h>

#include <Eigen/LU>

namespace galilean::monitor {
namespace {

using Eigen::Matrix2d;
using Eigen::Vector2d;

const Matrix2d kOne = Matrix2d::Identity();

TEST(JointGaussian, ACorrectionIsThatOfTheKalmanFilterAndReachesAllThatHangsOnIt) {
  JointGaussian joint;
  const auto a = joint.add(Vector2d(1, 2), 0.5 * kOne);
  const JointGaussian::Term of_a[] = {{a, kOne}};
  const auto b = joint.add(Vector2d(3, 2), of_a, 0.1 * kOne);
  const JointGaussian::Term measured[] = {{b, kOne}};
  joint.correct(measured, Vector2d(0.4, 0), 0.2 * kOne);

  const double gain_of_b = 0.6 / (0.6 + 0.2), gain_of_a = 0.5 / (0.6 + 0.2);
  EXPECT_TRUE(joint.mean(b).isApprox(Vector2d(3 + gain_of_b * 0.4, 2)));
  EXPECT_TRUE(joint.mean(a).isApprox(Vector2d(1 + gain_of_a * 0.4, 2)));
  EXPECT_TRUE(joint.covariance(b).isApprox((1 - gain_of_b) * 0.6 * kOne));
  EXPECT_TRUE(joint.covariance(a).isApprox((0.5 - gain_of_a * 0.5) * kOne));
  const JointGaussian::Term difference[] = {{b, kOne}, {a, -kOne}};
  const double shared = 0.5 - gain_of_b * 0.5;
  EXPECT_TRUE(joint.covariance(difference)
                  .isApprox(((1 - gain_of_b) * 0.6 + 0.5 - gain_of_a * 0.5 - 2 * shared) * kOne));
}

TEST(JointGaussian, WhatComesAndGoesLeavesTheRestAsItWas) {
  JointGaussian joint;
  const auto kept = joint.add(Eigen::Vector3d(1, 2, 3), 0.3 * Eigen::Matrix3d::Identity());
  const JointGaussian::Term of_kept[] = {{kept, Eigen::Matrix<double, 2, 3>::Identity()}};
  std::vector<JointGaussian::Block> others;
  for (int i = 0; i < 20; ++i)
    others.push_back(joint.add(Vector2d(i, -i), of_kept, 0.1 * i * kOne));
  const JointGaussian::Term apart[] = {{others[15], kOne}, {others[3], -kOne}};
  const JointGaussian::Matrix before = joint.covariance(apart);
  for (const int gone : {0, 7, 19, 12}) joint.remove(others[gone]);
  const auto fresh = joint.add(Vector2d(5, 5), kOne);

  EXPECT_TRUE(joint.mean(kept).isApprox(Eigen::Vector3d(1, 2, 3)));
  EXPECT_TRUE(joint.mean(others[15]).isApprox(Vector2d(15, -15)));
  EXPECT_TRUE(joint.covariance(apart).isApprox(before));
  const JointGaussian::Term of_both[] = {{fresh, kOne}, {others[15], kOne}};
  EXPECT_TRUE(joint.covariance(of_both).isApprox(joint.covariance(others[15]) + kOne))
      << "the new block has nothing in common with those that went";
}

TEST(JointGaussian, MovingAPartTurnsWhatItHasInCommonWithTheRest) {
  JointGaussian joint;
  const auto a = joint.add(Vector2d(1, 0), (Matrix2d() << 0.4, 0, 0, 0.1).finished());
  const JointGaussian::Term of_a[] = {{a, kOne}};
  const auto b = joint.add(Vector2d(2, 0), of_a, Matrix2d::Zero());
  const Matrix2d quarter_turn = (Matrix2d() << 0, -1, 1, 0).finished();
  joint.transform(a, Vector2d(0, 1), quarter_turn, 0.01 * kOne);

  EXPECT_TRUE(joint.covariance(a).isApprox((Matrix2d() << 0.11, 0, 0, 0.41).finished()));
  const JointGaussian::Term turned_back[] = {{a, quarter_turn.transpose()}, {b, -kOne}};
  EXPECT_TRUE(joint.covariance(turned_back).isApprox(0.01 * kOne))
      << "but for the noise it is b still";
}

}  // namespace
}  // namespace galilean::monitor
