// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/map/relocalization/heading_recovery.h"

#include <algorithm>
#include <cmath>

#include "monitor/map/estimation/frames.h"
#include "monitor/map/estimation/motion_model.h"
#include "monitor/map/estimation/visible_area.h"
#include "monitor/map/relocalization/heading_fit.h"

namespace galilean::monitor {
namespace {

constexpr double kMaxRange_m = 3.5;
constexpr double kMaxKnownRange_m = 2 * kMaxRange_m;  ///< landmarks further away cannot be seen
constexpr double kUnpushedFrom_m = 0.35;              ///< objects that are nearer may be pushed
constexpr double kWidestSearch_rad = 1.4;
constexpr double kDeviations = 3;
constexpr double kSameTurn_rad = 0.1;
constexpr double kLargeTurn_rad = 0.7;
constexpr double kSamePoint_m = 0.4;
constexpr int kExpectedFrames = 2, kUnexpectedFrames = 5;

std::vector<LabelledPoint> points_in(const msg::Sightings& frame) {
  std::vector<LabelledPoint> points;
  for (const auto& sighting : frame.items) {
    if (sighting.object_class != "trash" && sighting.object_class != "basket") continue;
    const auto measurement = measurement_of(sighting, frame);
    if (!measurement || !measurement->complete) continue;
    const Vec2& at_m = measurement->in_robot.mean_m;
    if (at_m.norm() > kUnpushedFrom_m && at_m.norm() < kMaxRange_m)
      points.push_back({at_m, label_of(sighting.object_class), 0});
  }
  return points;
}

/// Returns how many known landmarks are in the visible area of a robot at `pose`, while nothing of
/// their label is seen near them.
std::ptrdiff_t unseen_from(const Pose2& pose, const msg::Sightings& frame,
                           const std::vector<LabelledPoint>& seen,
                           const std::vector<LabelledPoint>& known) {
  return std::ranges::count_if(known, [&](const LabelledPoint& point) {
    const Vec2 at_m = in_robot(pose, point.position_m);
    const auto is_it = [&](const LabelledPoint& other) {
      return other.label == point.label && (other.position_m - at_m).norm() < kSamePoint_m;
    };
    return in_visible_area(frame, at_m) && std::ranges::none_of(seen, is_it);
  });
}

}  // namespace

void HeadingRecovery::update(const msg::Sightings& frame, Time now) {
  const auto seen = points_in(frame);
  const auto known = known_to(frame.robot, now);
  const double deviation_rad = std::sqrt(joint_.covariance(robots_.block(frame.robot))(2, 2));
  const Pose2 pose = robots_.pose(frame.robot);
  const double expected_rad = std::min(kDeviations * deviation_rad, kWidestSearch_rad);
  auto turn_rad = HeadingFit::find_turn(seen, known, pose, deviation_rad, expected_rad);
  if (!turn_rad)
    turn_rad = HeadingFit::find_turn(seen, known, pose, deviation_rad, kWidestSearch_rad);
  if (!turn_rad || std::abs(*turn_rad) < HeadingFit::kDeviation_rad) {
    suspicions_.erase(frame.robot);
    return;
  }
  const bool expected = std::abs(*turn_rad) <= expected_rad;
  if (!expected && !is_plausible(*turn_rad, frame, seen, known)) {
    suspicions_.erase(frame.robot);
    return;
  }
  if (frames_that_agree(frame.robot, *turn_rad) < (expected ? kExpectedFrames : kUnexpectedFrames))
    return;
  suspicions_.erase(frame.robot);
  turn(frame.robot, *turn_rad, deviation_rad, now);
}

bool HeadingRecovery::is_plausible(double turn_rad, const msg::Sightings& frame,
                                   const std::vector<LabelledPoint>& seen,
                                   const std::vector<LabelledPoint>& known) const {
  const Pose2 believed = robots_.pose(frame.robot);
  const Pose2 turned{believed.position_m, believed.heading_rad + turn_rad};
  const auto unseen = unseen_from(turned, frame, seen, known);
  const auto unseen_now = unseen_from(believed, frame, seen, known);
  return unseen < unseen_now || (unseen == unseen_now && std::abs(turn_rad) < kLargeTurn_rad);
}

std::vector<LabelledPoint> HeadingRecovery::known_to(const std::string& robot, Time now) const {
  const Vec2 robot_m = robots_.pose(robot).position_m;
  std::vector<LabelledPoint> known;
  for (const auto& landmark : landmarks_.all())
    if ((joint_.position(landmark.block) - robot_m).norm() < kMaxKnownRange_m &&
        landmark.is_confirmed() && !landmark.is_recent_of(robot, now))
      known.push_back(
          {joint_.position(landmark.block), label_of(landmark.object_class), landmark.id});
  return known;
}

int HeadingRecovery::frames_that_agree(const std::string& robot, double turn_rad) {
  Suspicion& suspicion = suspicions_[robot];
  const bool same = std::abs(suspicion.turn_rad - turn_rad) < kSameTurn_rad;
  suspicion = {turn_rad, same ? suspicion.frames + 1 : 1};
  return suspicion.frames;
}

void HeadingRecovery::turn(const std::string& robot, double by_rad, double deviation_rad,
                           Time now) {
  const auto block = robots_.block(robot);
  // The filter would correct only a part of a turn that is larger than its uncertainty. Therefore
  // the heading is made uncertain first.
  RobotMatrix noise = RobotMatrix::Zero();
  noise(2, 2) = std::max(0.0, by_rad * by_rad - deviation_rad * deviation_rad);
  joint_.inflate(block, noise);
  landmarks_.discard_recent(robot, now);
  const JointGaussian::Term heading[] = {{block, Eigen::RowVector3d(0, 0, 1)}};
  constexpr double kVariance = HeadingFit::kDeviation_rad * HeadingFit::kDeviation_rad;
  joint_.correct(heading, JointGaussian::Vector::Constant(1, by_rad),
                 JointGaussian::Matrix::Constant(1, 1, kVariance));
}

}  // namespace galilean::monitor
