#include "monitor/map/sighting_model.h"

#include <Eigen/LU>
#include <cmath>

#include "core/variable/variable.h"

namespace galilean::monitor {
namespace {

/// What a pixel makes of it is the larger part of a sighting's error; this is the rest.
constexpr double kPlaceError_m = 0.02;
/// A robot's foremost pixel may be of its nose or of its flank.
constexpr double kRobotShape_m = 0.2;

bool is_sound(const msg::Sighting& sighting) {
  const bool finite = std::isfinite(sighting.x_m) && std::isfinite(sighting.y_m) &&
                      std::isfinite(sighting.variance_xx) && std::isfinite(sighting.variance_xy) &&
                      std::isfinite(sighting.variance_yy) && std::isfinite(sighting.range_m);
  return finite && sighting.variance_xx >= 0 && sighting.variance_yy >= 0 &&
         sighting.variance_xx * sighting.variance_yy >=
             sighting.variance_xy * sighting.variance_xy &&
         !sighting.object_class.empty();
}

bool is_whole(const msg::Sighting& sighting) {
  return sighting.left_px > 0 && sighting.right_px < Image::kWidth - 1 && sighting.top_px > 0 &&
         sighting.bottom_px < Image::kHeight - 1;
}

}  // namespace

std::optional<Bearing> bearing_of(const msg::Sighting& sighting, const msg::Sightings& frame) {
  if (!is_sound(sighting)) return std::nullopt;
  Bearing result;
  const Mat2 turn = rotation_by(-frame.heading_rad);
  Mat2 in_odom;
  in_odom << sighting.variance_xx, sighting.variance_xy, sighting.variance_xy, sighting.variance_yy;
  const Vec2 from_robot_m = turn * Vec2(sighting.x_m - frame.x_m, sighting.y_m - frame.y_m);
  const double shape_m = sighting.object_class == "robot" ? kRobotShape_m : kPlaceError_m;
  result.from_robot.mean_m = from_robot_m;
  result.from_robot.covariance_m2 =
      turn * in_odom * turn.transpose() + shape_m * shape_m * Mat2::Identity();
  result.whole = is_whole(sighting);
  return result;
}

Expected expected_sighting(const JointGaussian& joint, JointGaussian::Part robot,
                           JointGaussian::Part seen) {
  const auto from = joint.mean(robot);
  const auto to = joint.mean(seen);
  const Mat2 turn = rotation_by(-from[2]);
  Expected expected;
  expected.from_robot_m = turn * (to.head<2>() - from.head<2>());
  Eigen::MatrixXd of_robot = Eigen::MatrixXd::Zero(2, from.size());
  of_robot.leftCols<2>() = -turn;
  of_robot.col(2) << expected.from_robot_m.y(), -expected.from_robot_m.x();
  Eigen::MatrixXd of_seen = Eigen::MatrixXd::Zero(2, to.size());
  of_seen.leftCols<2>() = turn;
  expected.terms = {{robot, of_robot}, {seen, of_seen}};
  return expected;
}

Fit fit_of(const JointGaussian& joint, const Expected& expected, const Gaussian2& from_robot) {
  const Mat2 own = joint.covariance(expected.terms);
  const Vec2 apart = from_robot.mean_m - expected.from_robot_m;
  const Mat2 sum = own + from_robot.covariance_m2;
  const double half_trace = own.trace() / 2;
  const double largest =
      half_trace + std::sqrt(std::max(0.0, half_trace * half_trace - own.determinant()));
  return {apart.dot(sum.inverse() * apart), std::sqrt(largest)};
}

Placed place_of(const JointGaussian& joint, JointGaussian::Part robot,
                const Gaussian2& from_robot) {
  const auto from = joint.mean(robot);
  const Mat2 turn = rotation_by(from[2]);
  const Vec2 offset = turn * from_robot.mean_m;
  Eigen::MatrixXd of_robot = Eigen::MatrixXd::Zero(2, from.size());
  of_robot.leftCols<2>().setIdentity();
  of_robot.col(2) << -offset.y(), offset.x();
  return {from.head<2>() + offset,
          {{robot, of_robot}},
          turn * from_robot.covariance_m2 * turn.transpose()};
}

}  // namespace galilean::monitor
