#include "monitor/map/relocalization/orientation.h"

#include <algorithm>
#include <cmath>

#include "monitor/map/estimation/frames.h"
#include "monitor/map/estimation/plain_view.h"
#include "monitor/map/estimation/robot_motion.h"
#include "monitor/map/relocalization/bearings_fit.h"

namespace galilean::monitor {
namespace {

constexpr double kMostRange_m = 3.5;
constexpr double kMostKnownRange_m = 2 * kMostRange_m;  ///< beyond, it is none of what is seen
constexpr double kUnpushedFrom_m = 0.35;                ///< what is nearer may be pushed
constexpr double kWidestSearch_rad = 1.4;
constexpr double kDeviations = 3;
constexpr double kSameTurn_rad = 0.1;
constexpr double kLargeTurn_rad = 0.7;
constexpr double kSameMark_m = 0.4;
constexpr int kExpectedFrames = 2, kUnexpectedFrames = 5;

std::vector<Mark> marks_in(const msg::Sightings& frame) {
  std::vector<Mark> marks;
  for (const auto& sighting : frame.items) {
    if (sighting.object_class != "trash" && sighting.object_class != "basket") continue;
    const auto bearing = bearing_of(sighting, frame);
    if (!bearing || !bearing->whole) continue;
    const Vec2& at_m = bearing->from_robot.mean_m;
    if (at_m.norm() > kUnpushedFrom_m && at_m.norm() < kMostRange_m)
      marks.push_back({at_m, mark_kind(sighting.object_class), 0});
  }
  return marks;
}

/// Known landmarks that ought to be in plain view from there, and none of their kind is about.
std::ptrdiff_t missed_from(const Pose2& pose, const msg::Sightings& frame,
                           const std::vector<Mark>& seen, const std::vector<Mark>& known) {
  return std::ranges::count_if(known, [&](const Mark& mark) {
    const Vec2 at_m = from_robot(pose, mark.in_map_m);
    const auto is_it = [&](const Mark& other) {
      return other.kind == mark.kind && (other.in_map_m - at_m).norm() < kSameMark_m;
    };
    return in_plain_view(frame, at_m) && std::ranges::none_of(seen, is_it);
  });
}

}  // namespace

void Orientation::look(const msg::Sightings& frame, Time now) {
  const auto seen = marks_in(frame);
  const auto known = known_to(frame.robot, now);
  const double deviation_rad = std::sqrt(joint_.covariance(robots_.part(frame.robot))(2, 2));
  const Pose2 pose = robots_.pose(frame.robot);
  const double expected_rad = std::min(kDeviations * deviation_rad, kWidestSearch_rad);
  auto turn_rad = BearingsFit::turn(seen, known, pose, deviation_rad, expected_rad);
  if (!turn_rad) turn_rad = BearingsFit::turn(seen, known, pose, deviation_rad, kWidestSearch_rad);
  if (!turn_rad || std::abs(*turn_rad) < BearingsFit::kDeviation_rad) {
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

bool Orientation::is_plausible(double turn_rad, const msg::Sightings& frame,
                               const std::vector<Mark>& seen,
                               const std::vector<Mark>& known) const {
  const Pose2 believed = robots_.pose(frame.robot);
  const Pose2 turned{believed.position_m, believed.heading_rad + turn_rad};
  const auto missed = missed_from(turned, frame, seen, known);
  const auto missed_now = missed_from(believed, frame, seen, known);
  return missed < missed_now || (missed == missed_now && std::abs(turn_rad) < kLargeTurn_rad);
}

std::vector<Mark> Orientation::known_to(const std::string& robot, Time now) const {
  const Vec2 robot_m = robots_.pose(robot).position_m;
  std::vector<Mark> known;
  for (const auto& landmark : landmarks_.all())
    if ((joint_.position(landmark.part) - robot_m).norm() < kMostKnownRange_m &&
        landmark.is_confirmed() && !landmark.is_recent_of(robot, now))
      known.push_back(
          {joint_.position(landmark.part), mark_kind(landmark.object_class), landmark.id});
  return known;
}

int Orientation::frames_that_agree(const std::string& robot, double turn_rad) {
  Suspicion& suspicion = suspicions_[robot];
  const bool same = std::abs(suspicion.turn_rad - turn_rad) < kSameTurn_rad;
  suspicion = {turn_rad, same ? suspicion.frames + 1 : 1};
  return suspicion.frames;
}

void Orientation::turn(const std::string& robot, double by_rad, double deviation_rad, Time now) {
  const auto part = robots_.part(robot);
  // A turn beyond what the filter holds for possible would else be believed in part only.
  RobotMatrix unsure = RobotMatrix::Zero();
  unsure(2, 2) = std::max(0.0, by_rad * by_rad - deviation_rad * deviation_rad);
  joint_.blur(part, unsure);
  landmarks_.discard_recent(robot, now);
  const JointGaussian::Term heading[] = {{part, Eigen::RowVector3d(0, 0, 1)}};
  constexpr double kVariance = BearingsFit::kDeviation_rad * BearingsFit::kDeviation_rad;
  joint_.correct(heading, JointGaussian::Vector::Constant(1, by_rad),
                 JointGaussian::Matrix::Constant(1, 1, kVariance));
}

}  // namespace galilean::monitor
