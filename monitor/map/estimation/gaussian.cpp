// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/map/estimation/gaussian.h"

#include <mrpt/math/distributions.h>

#include <Eigen/Geometry>
#include <Eigen/LU>

namespace galilean::monitor {

Mat2 rotation_matrix(double angle_rad) {
  return Eigen::Rotation2Dd(angle_rad).toRotationMatrix();
}

double squared_mahalanobis(const Gaussian2& a, const Gaussian2& b) {
  const Vec2 apart = a.mean_m - b.mean_m;
  const Mat2 unsure = a.covariance_m2 + b.covariance_m2;
  return apart.dot(unsure.inverse() * apart);
}

double association_gate() {
  static const double kGate = mrpt::math::chi2inv(0.99, 2);
  return kGate;
}

}  // namespace galilean::monitor
