#include "monitor/map/estimation/sighting_model.h"

#include <Eigen/LU>
#include <cmath>

#include "core/variable/variable.h"

namespace galilean::monitor {
namespace {

/// What a pixel makes of it is the larger part of a sighting's error; this is the rest.
constexpr double kPlaceError_m = 0.02;
/// A robot's foremost pixel may be of its nose or of its flank.
constexpr double kRobotShape_m = 0.2;
/// No direction can be told of what is nearer.
constexpr double kNearest_m = 0.05;

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

double bearing_rad(const Vec2& from_robot_m) {
  return std::atan2(from_robot_m.y(), from_robot_m.x());
}

Gaussian2 in_range_and_bearing(const Gaussian2& from_robot) {
  const Vec2& at_m = from_robot.mean_m;
  const double range_m = std::max(at_m.norm(), kNearest_m);
  Mat2 jacobian;
  jacobian.row(0) = at_m.transpose() / range_m;
  jacobian.row(1) << -at_m.y() / (range_m * range_m), at_m.x() / (range_m * range_m);
  return {{range_m, bearing_rad(at_m)}, jacobian * from_robot.covariance_m2 * jacobian.transpose()};
}

Vec2 difference(const Vec2& a, const Vec2& b) {
  return {a.x() - b.x(), wrap_angle(a.y() - b.y())};
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
  const Vec2 apart = joint.position(seen) - from.head<2>();
  const double range_m = std::max(apart.norm(), kNearest_m);
  Expected expected{.robot = robot, .seen = seen};
  expected.from_robot_m = rotated(apart, -from[2]);
  expected.range_bearing << range_m, bearing_rad(expected.from_robot_m);
  Mat2& of_place = expected.of_place;
  of_place.row(0) = apart.transpose() / range_m;
  of_place.row(1) << -apart.y() / (range_m * range_m), apart.x() / (range_m * range_m);
  expected.of_pose << -of_place, Vec2(0, -1);
  return expected;
}

Mat2 Expected::covariance(const JointGaussian& joint) const {
  const Mat2 cross = of_pose * joint.cross_covariance<3, 2>(robot, seen) * of_place.transpose();
  return of_pose * joint.cross_covariance<3, 3>(robot, robot) * of_pose.transpose() + cross +
         cross.transpose() +
         of_place * joint.cross_covariance<2, 2>(seen, seen) * of_place.transpose();
}

Fit fit_of(const JointGaussian& joint, const Expected& expected, const Gaussian2& from_robot) {
  const Mat2 own = expected.covariance(joint);
  const Gaussian2 seen = in_range_and_bearing(from_robot);
  const Vec2 apart = difference(seen.mean_m, expected.range_bearing);
  const Mat2 sum = own + seen.covariance_m2;
  const double range_m = expected.range_bearing.x();
  return {apart.dot(sum.inverse() * apart),
          std::sqrt(std::max(own(0, 0), range_m * range_m * own(1, 1)))};
}

void correct_by(JointGaussian& joint, const Expected& expected, const Gaussian2& from_robot) {
  const Gaussian2 seen = in_range_and_bearing(from_robot);
  const JointGaussian::Term terms[] = {{expected.robot, expected.of_pose},
                                       {expected.seen, expected.of_place}};
  joint.correct(terms, difference(seen.mean_m, expected.range_bearing), seen.covariance_m2);
}

Placed place_of(const JointGaussian& joint, JointGaussian::Part robot,
                const Gaussian2& from_robot) {
  const auto from = joint.mean(robot);
  const Mat2 turn = rotation_by(from[2]);
  const Vec2 offset = turn * from_robot.mean_m;
  Eigen::Matrix<double, 2, 3> of_pose;
  of_pose << Mat2::Identity(), Vec2(-offset.y(), offset.x());
  return {from.head<2>() + offset,
          {{{robot, of_pose}}},
          turn * from_robot.covariance_m2 * turn.transpose()};
}

}  // namespace galilean::monitor
