#include "monitor/map/relocalization/meetings.h"

#include <algorithm>
#include <optional>
#include <string>

#include "monitor/map/estimation/sighting_model.h"

namespace galilean::monitor {
namespace {

constexpr double kFreshPose_s = 0.3;
constexpr double kVaguestMeeting_m = 0.6;
/// A robot is too big and blurred a mark to tell more than landmarks do.
constexpr double kSurestMeeting_m = 0.15;
constexpr double kNearer = 0.75;
constexpr double kRangeError = 0.3;
/// Another robot that fits less badly than this could have been meant as well.
constexpr double kRivalGate = 25;

/// The only robot that can have been meant.
std::optional<Expected> met(const std::string& observer, const Gaussian2& from_robot,
                            const RobotPoses& robots, const JointGaussian& joint, Time now) {
  std::optional<Expected> found;
  for (const auto& [name, robot] : robots.all()) {
    if (name == observer || to_seconds(now - robot.moved) > kFreshPose_s) continue;
    const auto expected = expected_sighting(joint, robots.part(observer), robot.part);
    const Fit fit = fit_of(joint, expected, from_robot);
    if (fit.squared_distance > kRivalGate) continue;
    const bool fits = fit.squared_distance < same_thing_gate() &&
                      fit.deviation_m < kVaguestMeeting_m && fit.deviation_m > kSurestMeeting_m;
    if (found || !fits) return std::nullopt;
    found = expected;
  }
  return found;
}

/// A robot's green begins above the floor, and so it seems further away than it is.
Gaussian2 nearer(const Gaussian2& seen) {
  const Vec2 error_m = kRangeError * seen.mean_m;
  return {kNearer * seen.mean_m, seen.covariance_m2 + error_m * error_m.transpose()};
}

Gaussian2 in_map(const JointGaussian& joint, JointGaussian::Part observer, const Gaussian2& seen) {
  const auto placed = place_of(joint, observer, seen);
  return {placed.in_map_m, joint.covariance(placed.of) + placed.noise_m2};
}

bool may_be_any(const std::vector<Gaussian2>& robots, const Gaussian2& seen) {
  return std::ranges::any_of(
      robots, [&](const auto& robot) { return squared_mahalanobis(robot, seen) < kRivalGate; });
}

}  // namespace

void note_meetings(const msg::Sightings& frame, const RobotPoses& robots, JointGaussian& joint,
                   const std::vector<Gaussian2>& others, Time now) {
  for (const auto& sighting : frame.items) {
    if (sighting.object_class != "robot") continue;
    const auto bearing = bearing_of(sighting, frame);
    if (!bearing || !bearing->whole) continue;
    const Gaussian2 seen = nearer(bearing->from_robot);
    if (may_be_any(others, in_map(joint, robots.part(frame.robot), seen))) continue;
    if (const auto expected = met(frame.robot, seen, robots, joint, now))
      correct_by(joint, *expected, seen);
  }
}

}  // namespace galilean::monitor
