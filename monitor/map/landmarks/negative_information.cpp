#include <algorithm>
#include <cmath>
#include <utility>

#include "monitor/map/estimation/frames.h"
#include "monitor/map/estimation/plain_view.h"
#include "monitor/map/landmarks/landmark_map.h"

namespace galilean::monitor {
namespace {

constexpr double kLongestPeriod_s = 0.5;
constexpr Duration kOrientedFor = std::chrono::seconds(3);
constexpr double kPlainViewDeviation_m = 0.2;

/// Something of its class is about there.
bool is_seen(const msg::Sightings& frame, const Landmark& landmark, const Vec2& from_robot_m) {
  constexpr double kAbout_m = 0.4;
  return std::ranges::any_of(frame.items, [&](const auto& sighting) {
    const Vec2 at_m =
        rotated(Vec2(sighting.x_m - frame.x_m, sighting.y_m - frame.y_m), -frame.heading_rad);
    return sighting.object_class == landmark.object_class &&
           (at_m - from_robot_m).norm() < kAbout_m;
  });
}

}  // namespace

// One that recognises nothing may be elsewhere than it is believed to be, and misses what is there.
double LandmarkMap::looked_s(const std::string& robot, Time now) {
  const auto before = std::exchange(last_frame_.try_emplace(robot, now).first->second, now);
  if (now - oriented_.try_emplace(robot, now).first->second > kOrientedFor) return 0;
  return std::min(to_seconds(now - before), kLongestPeriod_s);
}

void LandmarkMap::penalize_unseen(const msg::Sightings& frame, const std::vector<Seen>& seen,
                                  double for_s) {
  if (for_s <= 0) return;
  const auto robot = robots_.part(frame.robot);
  const Pose2 pose = robots_.pose(frame.robot);
  for (std::size_t j = 0; j < landmarks_.size(); ++j) {
    Landmark& landmark = landmarks_[j];
    const auto is_it = [j](const Seen& each) { return each.landmark == j; };
    if (landmark.object_class == "obstacle" || std::ranges::any_of(seen, is_it)) continue;
    if (!in_plain_view(frame, from_robot(pose, joint_.position(landmark.part)))) continue;
    const auto expected = expected_sighting(joint_, robot, landmark.part);
    const Fit fit = fit_of(joint_, expected, {expected.from_robot_m, Mat2::Identity()});
    if (fit.deviation_m < kPlainViewDeviation_m) landmark.penalize(for_s);
  }
}

void LandmarkMap::penalize_unseen(const msg::Sightings& frame, const Viewpoint& from) {
  if (from.for_s <= 0) return;
  for (auto& landmark : landmarks_) {
    const Vec2 at_m = from_robot(from.pose, joint_.position(landmark.part));
    if (landmark.object_class == "obstacle" || !in_plain_view(frame, at_m)) continue;
    const double variance_m2 = joint_.covariance(landmark.part).trace() +
                               from.covariance.topLeftCorner<2, 2>().trace() +
                               at_m.squaredNorm() * from.covariance(2, 2);
    if (variance_m2 < 2 * kPlainViewDeviation_m * kPlainViewDeviation_m &&
        !is_seen(frame, landmark, at_m))
      landmark.penalize(from.for_s);
  }
}

}  // namespace galilean::monitor
