// SPDX-License-Identifier: BSD-3-Clause
#include "robot/perceptual/target_memory.h"

#include <algorithm>
#include <cmath>

namespace galilean::robot {
namespace {

constexpr double kSameObject_m = 0.25;    ///< added to what the camera's error explains
constexpr double kBoundSlack_m = 0.10;    ///< how much farther than its bound a remembered place
                                          ///< may be
constexpr double kBoundSlack_rad = 0.35;  ///< how far to the side of the blob it may be
constexpr double kBoundCertainty = 0.5;   ///< factor of the certainty if the foot is not seen
constexpr double kPictureMargin_px = 8;

double largest_error_m(const Mat2& covariance_m2) noexcept {
  return std::sqrt(covariance_m2.trace());
}

/// Returns the place where the object's front stands on the floor, in the robot frame.
Vec2 front_of(const Locate& object, const View& view) noexcept {
  const Vec2 centre = point_to_robot(view.robot, object.position_m) - view.camera.in_robot_m();
  const double range_m = centre.norm();
  const double front_m = std::max(0.0, range_m - object.radius_m);
  return view.camera.in_robot_m() + (range_m > 0 ? Vec2(centre * (front_m / range_m)) : centre);
}

/// Gives a blob whose foot is out of the picture the remembered place, if that is near enough.
/// Returns whether it did.
bool recall(Candidate& candidate, const Locate& remembered, const View& view) noexcept {
  const Vec2 centre = point_to_robot(view.robot, remembered.position_m) - view.camera.in_robot_m();
  Sighting& sighting = candidate.sighting;
  const double off_rad = std::abs(wrap_angle(bearing_rad(centre) - sighting.azimuth_rad));
  if (centre.norm() > sighting.range_m + kBoundSlack_m || off_rad > kBoundSlack_rad) return false;
  sighting.position_m = remembered.position_m;
  sighting.covariance_m2 = remembered.covariance_m2;
  sighting.range_m = centre.norm();
  return true;
}

const Candidate* same_object(const Locate& remembered, const Candidates& candidates) noexcept {
  const Candidate* best = nullptr;
  double best_m = 0;
  for (const Candidate& candidate : candidates) {
    const double apart_m = (candidate.sighting.position_m - remembered.position_m).norm();
    const double gate_m = kSameObject_m + 2 * largest_error_m(candidate.sighting.covariance_m2);
    if (apart_m > gate_m || (best && apart_m >= best_m)) continue;
    best = &candidate;
    best_m = apart_m;
  }
  return best;
}

void remember(Variable<Locate>& target, const Candidate& chosen, const Tick& tick) noexcept {
  target.value.position_m = chosen.sighting.position_m;
  target.value.covariance_m2 = chosen.sighting.covariance_m2;
  target.mark_written(chosen.certainty, tick.now, tick.number);
}

}  // namespace

void TargetMemory::update(Variable<Locate>& target, Candidates& candidates, const View& view,
                          const Tick& tick) const noexcept {
  const bool known = target.valid_at(tick.now);
  for (Candidate& candidate : candidates)
    if (candidate.range_is_bound && !(known && recall(candidate, target.value, view)))
      candidate.certainty *= kBoundCertainty;
  if (const Candidate* chosen = choose(target, candidates, view, tick.now)) {
    remember(target, *chosen, tick);
  } else if (known && view.camera.sees(front_of(target.value, view), kPictureMargin_px)) {
    const double left = target.certainty_at(tick.now) - miss_penalty;
    target.reliability.certainty = std::max(0.0, left);
    target.reliability.stamp = tick.now;
  }
}

const Candidate* TargetMemory::choose(const Variable<Locate>& target, const Candidates& candidates,
                                      const View& view, Time now) const noexcept {
  if (candidates.empty()) return nullptr;
  const Candidate& nearest = candidates[0];
  if (!target.valid_at(now)) return &nearest;
  if (const Candidate* same = same_object(target.value, candidates))
    return same->sighting.range_m - nearest.sighting.range_m > switch_distance_m ? &nearest : same;
  const Vec2 front = front_of(target.value, view);
  if (view.camera.sees(front, kPictureMargin_px)) return &nearest;
  const double remembered_m = (front - view.camera.in_robot_m()).norm() + target.value.radius_m;
  const bool better =
      nearest.sighting.range_m < remembered_m || nearest.certainty >= target.certainty_at(now);
  return better ? &nearest : nullptr;
}

}  // namespace galilean::robot
