// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/map/landmarks/negative_information.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "monitor/map/estimation/frames.h"
#include "monitor/map/estimation/visible_area.h"

namespace galilean::monitor {
namespace {

constexpr double kLongestPeriod_s = 0.5;
/// The time for which a robot's pose is trusted after the robot recognized a landmark.
constexpr Duration kTrustedFor = std::chrono::seconds(3);
/// The largest standard deviation with which a prediction is known to be in the visible area.
constexpr double kMaxObserverDeviation_m = 0.2;
/// An object of a frame may be the landmark if it is nearer to the prediction than this.
constexpr double kSameObject_m = 0.4;

bool is_in_frame(const msg::Sightings& frame, const Landmark& landmark, const Vec2& in_robot_m) {
  return std::ranges::any_of(frame.items, [&](const auto& sighting) {
    const Vec2 at_m =
        rotated(Vec2(sighting.x_m - frame.x_m, sighting.y_m - frame.y_m), -frame.heading_rad);
    return sighting.object_class == landmark.object_class &&
           (at_m - in_robot_m).norm() < kSameObject_m;
  });
}

}  // namespace

double NegativeInformation::looked_s(const std::string& robot,
                                     const std::vector<Observation>& observations, Time now) {
  for (const Observation& each : observations)
    if (each.landmark &&
        (!landmarks_.all()[*each.landmark].is_recent_of(robot, now) || robots_.all().size() == 1))
      recognized_[robot] = now;
  const auto before = std::exchange(last_frame_.try_emplace(robot, now).first->second, now);
  if (now - recognized_.try_emplace(robot, now).first->second > kTrustedFor) return 0;
  return std::min(to_seconds(now - before), kLongestPeriod_s);
}

void NegativeInformation::penalize_unseen(const msg::Sightings& frame,
                                          const std::vector<Observation>& observations,
                                          double for_s) {
  if (for_s <= 0) return;
  const auto robot = robots_.block(frame.robot);
  const Pose2 pose = robots_.pose(frame.robot);
  auto& landmarks = landmarks_.all();
  for (std::size_t j = 0; j < landmarks.size(); ++j) {
    Landmark& landmark = landmarks[j];
    const auto is_it = [j](const Observation& each) { return each.landmark == j; };
    if (landmark.object_class == "obstacle" || std::ranges::any_of(observations, is_it)) continue;
    if (!in_visible_area(frame, in_robot(pose, joint_.position(landmark.block)))) continue;
    const auto predicted = predict_measurement(joint_, robot, landmark.block);
    const Compatibility compatibility =
        compatibility_of(joint_, predicted, {predicted.in_robot_m, Mat2::Identity()});
    if (compatibility.deviation_m < kMaxObserverDeviation_m) landmark.penalize(for_s);
  }
}

void NegativeInformation::penalize_unseen(const msg::Sightings& frame, const Viewpoint& from) {
  if (from.for_s <= 0) return;
  for (auto& landmark : landmarks_.all()) {
    const Vec2 at_m = in_robot(from.pose, joint_.position(landmark.block));
    if (landmark.object_class == "obstacle" || !in_visible_area(frame, at_m)) continue;
    const double variance_m2 = joint_.covariance(landmark.block).trace() +
                               from.covariance.topLeftCorner<2, 2>().trace() +
                               at_m.squaredNorm() * from.covariance(2, 2);
    if (variance_m2 < 2 * kMaxObserverDeviation_m * kMaxObserverDeviation_m &&
        !is_in_frame(frame, landmark, at_m))
      landmark.penalize(from.for_s);
  }
}

}  // namespace galilean::monitor
