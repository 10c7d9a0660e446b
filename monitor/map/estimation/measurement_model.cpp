// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/map/estimation/measurement_model.h"

#include <Eigen/LU>
#include <cmath>

#include "core/variable/variable.h"

namespace galilean::monitor {
namespace {

/// The standard deviation that is added to a sighting's own error, which comes mostly from an error
/// of one pixel.
constexpr double kPositionError_m = 0.02;
/// The standard deviation that is added instead to the sighting of a robot, because its lowest
/// pixel may be of its nose or of its flank.
constexpr double kRobotShape_m = 0.2;
/// The least range in Jacobians, because those of range and azimuth grow without bound at range 0.
constexpr double kNearest_m = 0.05;

/// Nothing that a camera sees is further away, nor less known.
constexpr double kFarthestSighting_m = 1e6;
constexpr double kLargestVariance_m2 = 1e9;

/// Numbers that are not finite fail the comparisons.
bool is_sound(const msg::Sighting& sighting) {
  const bool plausible = std::abs(sighting.x_m) <= kFarthestSighting_m &&
                         std::abs(sighting.y_m) <= kFarthestSighting_m &&
                         std::abs(sighting.variance_xx) <= kLargestVariance_m2 &&
                         std::abs(sighting.variance_xy) <= kLargestVariance_m2 &&
                         std::abs(sighting.variance_yy) <= kLargestVariance_m2 &&
                         std::isfinite(sighting.range_m);
  return plausible && sighting.variance_xx >= 0 && sighting.variance_yy >= 0 &&
         sighting.variance_xx * sighting.variance_yy >=
             sighting.variance_xy * sighting.variance_xy &&
         !sighting.object_class.empty();
}

bool is_complete(const msg::Sighting& sighting) {
  return sighting.left_px > 0 && sighting.right_px < Image::kWidth - 1 && sighting.top_px > 0 &&
         sighting.bottom_px < Image::kHeight - 1;
}

double azimuth_rad(const Vec2& in_robot_m) {
  return std::atan2(in_robot_m.y(), in_robot_m.x());
}

Gaussian2 in_range_and_azimuth(const Gaussian2& in_robot) {
  const Vec2& at_m = in_robot.mean_m;
  const double range_m = std::max(at_m.norm(), kNearest_m);
  Mat2 jacobian;
  jacobian.row(0) = at_m.transpose() / range_m;
  jacobian.row(1) << -at_m.y() / (range_m * range_m), at_m.x() / (range_m * range_m);
  return {{range_m, azimuth_rad(at_m)}, jacobian * in_robot.covariance_m2 * jacobian.transpose()};
}

Vec2 difference(const Vec2& a, const Vec2& b) {
  return {a.x() - b.x(), wrap_angle(a.y() - b.y())};
}

}  // namespace

std::optional<Measurement> measurement_of(const msg::Sighting& sighting,
                                          const msg::Sightings& frame) {
  if (!is_sound(sighting)) return std::nullopt;
  Measurement result;
  const Mat2 turn = rotation_matrix(-frame.heading_rad);
  Mat2 in_odom;
  in_odom << sighting.variance_xx, sighting.variance_xy, sighting.variance_xy, sighting.variance_yy;
  const Vec2 in_robot_m = turn * Vec2(sighting.x_m - frame.x_m, sighting.y_m - frame.y_m);
  const double shape_m = sighting.object_class == "robot" ? kRobotShape_m : kPositionError_m;
  result.in_robot.mean_m = in_robot_m;
  result.in_robot.covariance_m2 =
      turn * in_odom * turn.transpose() + shape_m * shape_m * Mat2::Identity();
  result.complete = is_complete(sighting);
  return result;
}

PredictedMeasurement predict_measurement(const JointGaussian& joint, JointGaussian::Block robot,
                                         JointGaussian::Block seen) {
  const auto from = joint.mean(robot);
  const Vec2 apart = joint.position(seen) - from.head<2>();
  const double range_m = std::max(apart.norm(), kNearest_m);
  PredictedMeasurement predicted{.robot = robot, .seen = seen};
  predicted.in_robot_m = rotated(apart, -from[2]);
  predicted.range_azimuth << range_m, azimuth_rad(predicted.in_robot_m);
  Mat2& seen_jacobian = predicted.seen_jacobian;
  seen_jacobian.row(0) = apart.transpose() / range_m;
  seen_jacobian.row(1) << -apart.y() / (range_m * range_m), apart.x() / (range_m * range_m);
  predicted.pose_jacobian << -seen_jacobian, Vec2(0, -1);
  return predicted;
}

Mat2 PredictedMeasurement::covariance(const JointGaussian& joint) const {
  const Mat2 cross =
      pose_jacobian * joint.cross_covariance<3, 2>(robot, seen) * seen_jacobian.transpose();
  return pose_jacobian * joint.cross_covariance<3, 3>(robot, robot) * pose_jacobian.transpose() +
         cross + cross.transpose() +
         seen_jacobian * joint.cross_covariance<2, 2>(seen, seen) * seen_jacobian.transpose();
}

Compatibility compatibility_of(const JointGaussian& joint, const PredictedMeasurement& predicted,
                               const Gaussian2& in_robot) {
  const Mat2 own = predicted.covariance(joint);
  const Gaussian2 seen = in_range_and_azimuth(in_robot);
  const Vec2 apart = difference(seen.mean_m, predicted.range_azimuth);
  const Mat2 sum = own + seen.covariance_m2;
  const double range_m = predicted.range_azimuth.x();
  return {apart.dot(sum.inverse() * apart),
          std::sqrt(std::max(own(0, 0), range_m * range_m * own(1, 1)))};
}

void correct_by(JointGaussian& joint, const PredictedMeasurement& predicted,
                const Gaussian2& in_robot) {
  const Gaussian2 seen = in_range_and_azimuth(in_robot);
  const JointGaussian::Term terms[] = {{predicted.robot, predicted.pose_jacobian},
                                       {predicted.seen, predicted.seen_jacobian}};
  joint.correct(terms, difference(seen.mean_m, predicted.range_azimuth), seen.covariance_m2);
}

InverseMeasurement inverse_measurement(const JointGaussian& joint, JointGaussian::Block robot,
                                       const Gaussian2& in_robot) {
  const auto from = joint.mean(robot);
  const Mat2 turn = rotation_matrix(from[2]);
  const Vec2 offset = turn * in_robot.mean_m;
  Eigen::Matrix<double, 2, 3> pose_jacobian;
  pose_jacobian << Mat2::Identity(), Vec2(-offset.y(), offset.x());
  return {from.head<2>() + offset,
          {{{robot, pose_jacobian}}},
          turn * in_robot.covariance_m2 * turn.transpose()};
}

}  // namespace galilean::monitor
