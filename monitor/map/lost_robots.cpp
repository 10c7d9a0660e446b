#include "monitor/map/lost_robots.h"

#include <algorithm>
#include <cmath>

#include "monitor/map/transport.h"

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
std::vector<const Thing*> LostRobots::landmarks() const {
  std::vector<const Thing*> result;
  for (const auto& thing : things_.all())
    if (thing.established() && thing.object_class != "obstacle") result.push_back(&thing);
  return result;
}

Mark LostRobots::mark_of(const Thing& thing) const {
  return {joint_.position(thing.part), mark_kind(thing.object_class), thing.id};
}

/// Of what it saw lately, nearly all is new, and nobody else saw it.
bool LostRobots::recognises_nothing(const std::string& robot) const {
  std::size_t fresh = 0, known = 0;
  for (const Thing* thing : landmarks())
    if (thing->was_seen_by(robot, now_ - Thing::kLately))
      ++(thing->is_new_of(robot, now_) ? fresh : known);
  return fresh >= TurnedRobot::kLeastAgreeing && fresh > 2 * known;
}

void LostRobots::turn_back(const std::string& robot, const std::vector<Mark>& others_know) {
  std::vector<Mark> seen, known = others_know;
  std::vector<JointGaussian::Part> own{robots_.part(robot)};
  for (const Thing* thing : landmarks()) {
    if (thing->is_new_of(robot, now_)) {
      seen.push_back(mark_of(*thing));
      own.push_back(thing->part);
    } else if (!thing->was_seen_by(robot, now_ - Thing::kLately)) {
      known.push_back(mark_of(*thing));
    }
  }
  const Vec2 robot_m = robots_.pose(robot).position_m;
  const auto fit = TurnedRobot::fit(seen, known, robot_m, most_shift_m(robot));
  // What others know beside it is put right by what they tell, and needs no laying back.
  const bool needless = fit && !others_know.empty() && is_there_already(robot_m, *fit);
  if (fit && !needless) lay(own, *fit);
}

void LostRobots::rejoin(const std::string& robot, const std::vector<Mark>& others_know) {
  std::vector<Mark> seen, known = others_know;
  std::vector<JointGaussian::Part> own{robots_.part(robot)};
  for (const Thing* thing : landmarks()) {
    const bool lately = thing->was_seen_by(robot, now_ - Thing::kLately);
    const bool shared = thing->seen_by.size() > 1;
    if (lately) seen.push_back(mark_of(*thing));
    if (shared) known.push_back(mark_of(*thing));
    if (lately && !shared) own.push_back(thing->part);
  }
  const Vec2 robot_m = robots_.pose(robot).position_m;
  const auto fit = TurnedRobot::fit(seen, known, robot_m, most_shift_m(robot));
  if (fit && !is_there_already(robot_m, *fit)) lay(own, *fit);
}

/// One that knows how badly it is lost may be anywhere there.
double LostRobots::most_shift_m(const std::string& robot) const {
  const double deviation_m = std::sqrt(robots_.position(robot).covariance_m2.trace());
  return std::clamp(kLostDeviations * deviation_m, TurnedRobot::kMostShift_m, kFarthestShift_m);
}

void LostRobots::lay(const std::vector<JointGaussian::Part>& robot_and_own, const RigidFit& fit) {
  transport(joint_, robot_and_own, fit);
  for (const auto& pair : fit.agreeing) things_.unite(pair.map_index, pair.other_index);
}

}  // namespace galilean::monitor
