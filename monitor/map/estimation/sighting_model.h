#pragma once

#include <Eigen/Core>
#include <array>
#include <optional>

#include "core/wire/messages.h"
#include "monitor/map/estimation/gaussian.h"
#include "monitor/map/estimation/joint_gaussian.h"

namespace galilean::monitor {

/// Where a robot saw something, from its centre: x forward, y left.
struct Bearing {
  Gaussian2 from_robot;
  bool whole = false;  ///< no edge of the picture cuts it: its place can be relied upon
};

/// Nothing if the message is none that a robot can mean.
[[nodiscard]] std::optional<Bearing> bearing_of(const msg::Sighting& sighting,
                                                const msg::Sightings& frame);

/// What is expected of a sighting, and how it depends on what is estimated. In range and bearing,
/// for a bearing is the heading's error and no more, however large that is; x and y bend with it.
///   law     range = |landmark - robot|, bearing = direction of (landmark - robot) - heading
struct Expected {
  Vec2 from_robot_m;   ///< x forward, y left
  Vec2 range_bearing;  ///< [m, rad]
  JointGaussian::Part robot, seen;
  /// Of range_bearing, by the robot's x, y, heading and by the landmark's x, y.
  Eigen::Matrix<double, 2, 3> of_pose;
  Mat2 of_place;

  /// What of it is not known.
  [[nodiscard]] Mat2 covariance(const JointGaussian& joint) const;
};
/// `seen`'s first two numbers are its place in the map frame: a landmark or another robot.
[[nodiscard]] Expected expected_sighting(const JointGaussian& joint, JointGaussian::Part robot,
                                         JointGaussian::Part seen);

/// How well a sighting fits what is expected of it: squared Mahalanobis distance, and the standard
/// deviation of what is expected alone, along its longest axis.
struct Fit {
  double squared_distance = 0;
  double deviation_m = 0;
};
[[nodiscard]] Fit fit_of(const JointGaussian& joint, const Expected& expected,
                         const Gaussian2& from_robot);
/// Corrects all that hangs on what was expected by what was seen.
void correct_by(JointGaussian& joint, const Expected& expected, const Gaussian2& from_robot);

/// The place of something seen, as a function of the robot's pose.
struct Placed {
  Vec2 in_map_m;
  std::array<JointGaussian::Term, 1> of;
  Mat2 noise_m2;
};
[[nodiscard]] Placed place_of(const JointGaussian& joint, JointGaussian::Part robot,
                              const Gaussian2& from_robot);

}  // namespace galilean::monitor
