#include "monitor/map/gaussian.h"

#include <mrpt/math/distributions.h>
#include <mrpt/poses/CPointPDFGaussian.h>

#include <Eigen/Geometry>

namespace galilean::monitor {
namespace {

mrpt::poses::CPointPDFGaussian to_mrpt(const Gaussian2& from) {
  mrpt::poses::CPointPDFGaussian to(mrpt::poses::CPoint3D(from.mean_m.x(), from.mean_m.y(), 0));
  to.cov.setIdentity();  // the third dimension plays no part, but must not be singular
  for (int row = 0; row < 2; ++row)
    for (int column = 0; column < 2; ++column)
      to.cov(row, column) = from.covariance_m2(row, column);
  return to;
}

}  // namespace

Mat2 rotation_by(double angle_rad) {
  return Eigen::Rotation2Dd(angle_rad).toRotationMatrix();
}

Gaussian2 fused(const Gaussian2& a, const Gaussian2& b) {
  mrpt::poses::CPointPDFGaussian both;
  both.bayesianFusion(to_mrpt(a), to_mrpt(b));
  Gaussian2 result;
  result.mean_m = {both.mean.x(), both.mean.y()};
  result.covariance_m2 << both.cov(0, 0), both.cov(0, 1), both.cov(1, 0), both.cov(1, 1);
  return result;
}

double squared_mahalanobis(const Gaussian2& a, const Gaussian2& b) {
  const double distance = to_mrpt(a).mahalanobisDistanceTo(to_mrpt(b), true);
  return distance * distance;
}

double same_thing_gate() {
  static const double kGate = mrpt::math::chi2inv(0.99, 2);
  return kGate;
}

}  // namespace galilean::monitor
