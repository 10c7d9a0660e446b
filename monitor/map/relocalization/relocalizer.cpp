// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/map/relocalization/relocalizer.h"

#include <algorithm>
#include <cmath>

#include "monitor/map/relocalization/local_rigid_fit.h"
#include "monitor/map/relocalization/transform_blocks.h"

namespace galilean::monitor {
namespace {

/// A robot is searched for within this many standard deviations of its estimated position.
constexpr double kSearchDeviations = 3;
constexpr double kMaxSearch_m = 6;

}  // namespace

void Relocalizer::relocalize(const std::string& robot, Time now,
                             const std::vector<LabelledPoint>& known_to_others) {
  now_ = now;
  if (recognizes_nothing(robot)) relocalize_recent(robot, known_to_others);
  rejoin(robot, known_to_others);
}

// Obstacles are left out, because robots report them and the camera does not see them again.
std::vector<const Landmark*> Relocalizer::stable_landmarks() const {
  std::vector<const Landmark*> result;
  for (const auto& landmark : landmarks_.all())
    if (landmark.is_confirmed() && landmark.object_class != "obstacle") result.push_back(&landmark);
  return result;
}

LabelledPoint Relocalizer::point_of(const Landmark& landmark) const {
  return {joint_.position(landmark.block), label_of(landmark.object_class), landmark.id};
}

// A robot recognizes nothing if nearly all landmarks that it saw lately are its own recent ones.
bool Relocalizer::recognizes_nothing(const std::string& robot) const {
  std::size_t recent = 0, known = 0;
  for (const Landmark* landmark : stable_landmarks())
    if (landmark->was_seen_by(robot, now_ - Landmark::kObservationWindow))
      ++(landmark->is_recent_of(robot, now_) ? recent : known);
  return recent >= LocalRigidFit::kLeastAgreeing && recent > 2 * known;
}

void Relocalizer::relocalize_recent(const std::string& robot,
                                    const std::vector<LabelledPoint>& known_to_others) {
  std::vector<LabelledPoint> seen, known = known_to_others;
  std::vector<JointGaussian::Block> own{robots_.block(robot)};
  for (const Landmark* landmark : stable_landmarks()) {
    if (landmark->is_recent_of(robot, now_)) {
      seen.push_back(point_of(*landmark));
      own.push_back(landmark->block);
    } else if (!landmark->was_seen_by(robot, now_ - Landmark::kObservationWindow)) {
      known.push_back(point_of(*landmark));
    }
  }
  const auto fit = find(robot, seen, known);
  // The landmarks that groups share correct a small difference from other groups.
  const bool needless = fit && !known_to_others.empty() && is_in_place(robot, *fit);
  if (fit && !needless) apply(own, *fit);
}

void Relocalizer::rejoin(const std::string& robot,
                         const std::vector<LabelledPoint>& known_to_others) {
  std::vector<LabelledPoint> seen, known = known_to_others;
  std::vector<JointGaussian::Block> own{robots_.block(robot)};
  for (const Landmark* landmark : stable_landmarks()) {
    const bool lately = landmark->was_seen_by(robot, now_ - Landmark::kObservationWindow);
    const bool shared = landmark->seen_by.size() > 1;
    if (lately) seen.push_back(point_of(*landmark));
    if (shared) known.push_back(point_of(*landmark));
    if (lately && !shared) own.push_back(landmark->block);
  }
  const auto fit = find(robot, seen, known);
  if (fit && !is_in_place(robot, *fit)) apply(own, *fit);
}

std::optional<RigidFit> Relocalizer::find(const std::string& robot,
                                          const std::vector<LabelledPoint>& seen,
                                          const std::vector<LabelledPoint>& known) const {
  const Gaussian2 at = robots_.position(robot);
  const double shift_m = kSearchDeviations * std::sqrt(at.covariance_m2.trace());
  return LocalRigidFit::find(seen, known, at.mean_m,
                             std::clamp(shift_m, LocalRigidFit::kMaxShift_m, kMaxSearch_m));
}

bool Relocalizer::is_in_place(const std::string& robot, const RigidFit& fit) const {
  return is_negligible(robots_.pose(robot).position_m, fit);
}

void Relocalizer::apply(const std::vector<JointGaussian::Block>& robot_and_own,
                        const RigidFit& fit) {
  transform_blocks(joint_, robot_and_own, fit);
  for (const auto& pair : fit.agreeing) landmarks_.merge(pair.map_index, pair.other_index);
}

}  // namespace galilean::monitor
