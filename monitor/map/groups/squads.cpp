#include "monitor/map/groups/squads.h"

#include <algorithm>
#include <limits>

#include "monitor/map/estimation/frames.h"

namespace galilean::monitor {
namespace {

double distance_m(const Squad& squad, const Vec2& at_m) {
  double nearest_m = std::numeric_limits<double>::infinity();
  for (const auto& [name, robot] : squad.poses.all())
    nearest_m = std::min(nearest_m, (squad.poses.pose(name).position_m - at_m).norm());
  return nearest_m;
}

}  // namespace

Squad& Squads::join(const std::string& robot, const Pose2& in_odom) {
  if (const auto known = squad_of_.find(robot); known != squad_of_.end()) return *known->second;
  starts_.hear(robot);
  Squad* squad = nearest_with_room(in_map(starts_.of(robot).origin, in_odom.position_m));
  if (!squad) squad = squads_.emplace_back(std::make_unique<Squad>(starts_, ids_)).get();
  squad->placed |= starts_.is_given(robot) || squad == squads_.front().get();
  squad_of_[robot] = squad;
  return *squad;
}

std::vector<Squad*> Squads::others_near(const Squad& squad, const Vec2& at_m,
                                        double within_m) const {
  std::vector<Squad*> near;
  if (!squad.placed) return near;
  for (const auto& other : squads_)
    if (other.get() != &squad && other->placed && other->reaches(at_m, within_m))
      near.push_back(other.get());
  return near;
}

Squad* Squads::nearest_with_room(const Vec2& at_m) const {
  Squad* nearest = nullptr;
  double nearest_m = kNear_m;
  for (const auto& squad : squads_) {
    const auto is_its = [&](const auto& robot) { return robot.second == squad.get(); };
    const auto robots = static_cast<std::size_t>(std::ranges::count_if(squad_of_, is_its));
    if (robots >= most_robots_) continue;
    if (squad == squads_.front()) return squad.get();
    const double away_m = distance_m(*squad, at_m);
    if (away_m >= nearest_m) continue;
    nearest = squad.get();
    nearest_m = away_m;
  }
  return nearest;
}

}  // namespace galilean::monitor
