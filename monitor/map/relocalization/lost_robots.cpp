#include "monitor/map/relocalization/lost_robots.h"

#include <algorithm>
#include <cmath>

#include "monitor/map/relocalization/transport.h"

namespace galilean::monitor {
namespace {

constexpr double kLostDeviations = 3, kFarthestShift_m = 6;

}  // namespace

void LostRobots::lay_back(const std::string& robot, Time now,
                          const std::vector<Mark>& others_know) {
  now_ = now;
  if (recognises_nothing(robot)) turn_back(robot, others_know);
  rejoin(robot, others_know);
}

/// What stays where it is for a while, and was seen often enough.
std::vector<const Landmark*> LostRobots::landmarks() const {
  std::vector<const Landmark*> result;
  for (const auto& landmark : landmarks_.all())
    if (landmark.is_confirmed() && landmark.object_class != "obstacle") result.push_back(&landmark);
  return result;
}

Mark LostRobots::mark_of(const Landmark& landmark) const {
  return {joint_.position(landmark.part), mark_kind(landmark.object_class), landmark.id};
}

/// Of what it saw lately, nearly all is new, and nobody else saw it.
bool LostRobots::recognises_nothing(const std::string& robot) const {
  std::size_t fresh = 0, known = 0;
  for (const Landmark* landmark : landmarks())
    if (landmark->was_seen_by(robot, now_ - Landmark::kObservationWindow))
      ++(landmark->is_recent_of(robot, now_) ? fresh : known);
  return fresh >= TurnedRobot::kLeastAgreeing && fresh > 2 * known;
}

void LostRobots::turn_back(const std::string& robot, const std::vector<Mark>& others_know) {
  std::vector<Mark> seen, known = others_know;
  std::vector<JointGaussian::Part> own{robots_.part(robot)};
  for (const Landmark* landmark : landmarks()) {
    if (landmark->is_recent_of(robot, now_)) {
      seen.push_back(mark_of(*landmark));
      own.push_back(landmark->part);
    } else if (!landmark->was_seen_by(robot, now_ - Landmark::kObservationWindow)) {
      known.push_back(mark_of(*landmark));
    }
  }
  const auto fit = find(robot, seen, known);
  // What others know beside it is put right by what they tell, and needs no laying back.
  const bool needless = fit && !others_know.empty() && is_there(robot, *fit);
  if (fit && !needless) lay(own, *fit);
}

void LostRobots::rejoin(const std::string& robot, const std::vector<Mark>& others_know) {
  std::vector<Mark> seen, known = others_know;
  std::vector<JointGaussian::Part> own{robots_.part(robot)};
  for (const Landmark* landmark : landmarks()) {
    const bool lately = landmark->was_seen_by(robot, now_ - Landmark::kObservationWindow);
    const bool shared = landmark->seen_by.size() > 1;
    if (lately) seen.push_back(mark_of(*landmark));
    if (shared) known.push_back(mark_of(*landmark));
    if (lately && !shared) own.push_back(landmark->part);
  }
  const auto fit = find(robot, seen, known);
  if (fit && !is_there(robot, *fit)) lay(own, *fit);
}

/// One that knows how badly it is lost may be anywhere there.
std::optional<RigidFit> LostRobots::find(const std::string& robot, const std::vector<Mark>& seen,
                                         const std::vector<Mark>& known) const {
  const Gaussian2 at = robots_.position(robot);
  const double shift_m = kLostDeviations * std::sqrt(at.covariance_m2.trace());
  return TurnedRobot::fit(seen, known, at.mean_m,
                          std::clamp(shift_m, TurnedRobot::kMostShift_m, kFarthestShift_m));
}

bool LostRobots::is_there(const std::string& robot, const RigidFit& fit) const {
  return is_there_already(robots_.pose(robot).position_m, fit);
}

void LostRobots::lay(const std::vector<JointGaussian::Part>& robot_and_own, const RigidFit& fit) {
  transport(joint_, robot_and_own, fit);
  for (const auto& pair : fit.agreeing) landmarks_.merge(pair.map_index, pair.other_index);
}

}  // namespace galilean::monitor
