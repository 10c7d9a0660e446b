// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/map/estimation/mutual_observations.h"

#include <algorithm>
#include <optional>
#include <string>

#include "monitor/map/estimation/measurement_model.h"

namespace galilean::monitor {
namespace {

/// The greatest age of a robot's pose that a frame is compared with.
constexpr double kFreshPose_s = 0.3;
constexpr double kMaxMutualDeviation_m = 0.6;
/// The standard deviation of a prediction above which the sighting of a robot helps. A robot is a
/// large and blurred target, so its sighting tells less than landmarks do.
constexpr double kMinDeviation_m = 0.15;
/// A robot's green begins above the floor, so the robot seems further away than it is. Ranges are
/// multiplied by this factor, and may still err by this share (standard deviation).
constexpr double kRangeFactor = 0.75;
constexpr double kRangeError = 0.3;
/// A robot at a squared Mahalanobis distance below this may be the one that was seen.
constexpr double kRivalGate = 25;

/// Returns the prediction for the only robot that can have been seen. Returns nothing if several
/// robots can have been seen, or none.
std::optional<PredictedMeasurement> met(const std::string& observer, const Gaussian2& in_robot,
                                        const RobotPoses& robots, const JointGaussian& joint,
                                        Time now) {
  std::optional<PredictedMeasurement> found;
  for (const auto& [name, robot] : robots.all()) {
    if (name == observer || to_seconds(now - robot.last_predicted) > kFreshPose_s) continue;
    const auto predicted = predict_measurement(joint, robots.block(observer), robot.block);
    const Compatibility compatibility = compatibility_of(joint, predicted, in_robot);
    if (compatibility.squared_distance > kRivalGate) continue;
    const bool compatible = compatibility.squared_distance < association_gate() &&
                            compatibility.deviation_m < kMaxMutualDeviation_m &&
                            compatibility.deviation_m > kMinDeviation_m;
    if (found || !compatible) return std::nullopt;
    found = predicted;
  }
  return found;
}

Gaussian2 with_range_corrected(const Gaussian2& seen) {
  const Vec2 error_m = kRangeError * seen.mean_m;
  return {kRangeFactor * seen.mean_m, seen.covariance_m2 + error_m * error_m.transpose()};
}

Gaussian2 in_map(const JointGaussian& joint, JointGaussian::Block observer, const Gaussian2& seen) {
  const auto inverse = inverse_measurement(joint, observer, seen);
  return {inverse.in_map_m, joint.covariance(inverse.terms) + inverse.noise_m2};
}

bool may_be_any(const std::vector<Gaussian2>& robots, const Gaussian2& seen) {
  return std::ranges::any_of(
      robots, [&](const auto& robot) { return squared_mahalanobis(robot, seen) < kRivalGate; });
}

}  // namespace

void correct_by_mutual_observations(const msg::Sightings& frame, const RobotPoses& robots,
                                    JointGaussian& joint, const std::vector<Gaussian2>& others,
                                    Time now) {
  for (const auto& sighting : frame.items) {
    if (sighting.object_class != "robot") continue;
    const auto measurement = measurement_of(sighting, frame);
    if (!measurement || !measurement->complete) continue;
    const Gaussian2 seen = with_range_corrected(measurement->in_robot);
    if (may_be_any(others, in_map(joint, robots.block(frame.robot), seen))) continue;
    if (const auto predicted = met(frame.robot, seen, robots, joint, now))
      correct_by(joint, *predicted, seen);
  }
}

}  // namespace galilean::monitor
