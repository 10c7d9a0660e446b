// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <array>
#include <optional>

#include "core/wire/messages.h"
#include "monitor/map/estimation/gaussian.h"
#include "monitor/map/estimation/joint_gaussian.h"

namespace galilean::monitor {

/// One object in one camera frame.
struct Measurement {
  Gaussian2 in_robot;  ///< robot frame: x forward, y left
  bool complete =
      false;  ///< whether no edge of the picture cuts the blob: its position is reliable
};

/// Returns the sighting as a measurement in the robot frame.
/// Errors: nothing for a sighting that no camera can have made (not finite, no covariance, no
/// class).
[[nodiscard]] std::optional<Measurement> measurement_of(const msg::Sighting& sighting,
                                                        const msg::Sightings& frame);

/// What the filter expects the camera to measure of `seen`, with the Jacobians of that. It is said
/// in range and azimuth, because azimuth errs by the heading's error and no more however large that
/// is, whereas x and y are not linear in the heading.
///   law     range = |seen - robot|, azimuth = direction of (seen - robot) - heading
struct PredictedMeasurement {
  Vec2 in_robot_m;     ///< robot frame: x forward, y left
  Vec2 range_azimuth;  ///< [m, rad]
  JointGaussian::Block robot, seen;
  Eigen::Matrix<double, 2, 3> pose_jacobian;  ///< by the robot's x, y [m] and heading [rad]
  Mat2 seen_jacobian;                         ///< by the seen object's x, y [m]

  /// Returns the covariance of range and azimuth [m², m·rad, rad²] due to the state alone.
  [[nodiscard]] Mat2 covariance(const JointGaussian& joint) const;
};
/// Predicts a measurement of `seen`, a landmark or another robot, by `robot`.
[[nodiscard]] PredictedMeasurement predict_measurement(const JointGaussian& joint,
                                                       JointGaussian::Block robot,
                                                       JointGaussian::Block seen);

/// How well a measurement agrees with what was predicted (individual compatibility).
struct Compatibility {
  double squared_distance = 0;  ///< squared Mahalanobis distance of the innovation
  double deviation_m = 0;       ///< standard deviation of the prediction along its longest axis
};
[[nodiscard]] Compatibility compatibility_of(const JointGaussian& joint,
                                             const PredictedMeasurement& predicted,
                                             const Gaussian2& in_robot);
/// Corrects the whole state by a measurement at `in_robot` of what was predicted.
void correct_by(JointGaussian& joint, const PredictedMeasurement& predicted,
                const Gaussian2& in_robot);

/// The position of what was measured as a function of the robot's pose, with the Jacobian of that:
/// what a new landmark is added to the state with.
struct InverseMeasurement {
  Vec2 in_map_m;
  std::array<JointGaussian::Term, 1> terms;  ///< by the robot's x, y and heading
  Mat2 noise_m2;                             ///< the measurement's covariance in the map frame
};
[[nodiscard]] InverseMeasurement inverse_measurement(const JointGaussian& joint,
                                                     JointGaussian::Block robot,
                                                     const Gaussian2& in_robot);

}  // namespace galilean::monitor
