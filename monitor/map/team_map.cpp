#include "monitor/map/team_map.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "monitor/map/estimation/frames.h"
#include "monitor/map/estimation/plain_view.h"
#include "monitor/map/relocalization/meetings.h"

namespace galilean::monitor {
namespace {

constexpr double kAlignEvery_s = 0.5;
constexpr double kFloorStep_m = 0.05;  ///< standing still is no new evidence
constexpr double kFloorTurn_rad = 0.1;
constexpr double kMostSightRange_m = 4;  ///< beyond, the end of a sight line is too unsure
constexpr double kTouchDeviation_m = 0.05;

bool is_obstacle(const msg::Variable& variable) {
  return variable.type == msg::Variable_Constants::LOCATE && variable.valid &&
         variable.object_class == "obstacle" && variable.values.size() >= 2 &&
         std::isfinite(variable.values[0]) && std::isfinite(variable.values[1]);
}

}  // namespace

bool TeamMap::move(const std::string& robot, const Pose2& in_odom, Time now) {
  if (!in_odom.position_m.allFinite() || !std::isfinite(in_odom.heading_rad)) return false;
  Squad& squad = squads_.join(robot, in_odom);
  if (squad.poses.knows(robot))
    squad.landmarks.inflate_near(robot, std::max(0.0, to_seconds(now - squad.poses.moved(robot))));
  Heard& heard = heard_[robot];
  squad.poses.move(robot, in_odom, heard.senses.touches(now), now);
  heard.at = now;
  return true;
}

void TeamMap::note(const msg::RobotState& state, Time now) {
  if (!move(state.robot, {{state.x_m, state.y_m}, state.heading_rad}, now)) return;
  const Vec2 at_m = squads_.of(state.robot).poses.pose(state.robot).position_m;
  Heard& robot = heard_[state.robot];
  robot.senses.note(state);
  if ((at_m - robot.last_stood_m).norm() < kFloorStep_m) return;
  robot.last_stood_m = at_m;
  floor_.stood(at_m);
}

void TeamMap::note(const msg::Sightings& frame, Time now) {
  if (!move(frame.robot, {{frame.x_m, frame.y_m}, frame.heading_rad}, now)) return;
  Squad& squad = squads_.of(frame.robot);
  const Pose2 odom = squad.poses.frame(frame.robot);
  const auto grippers_m = carried_.grippers_m();
  msg::Sightings landmarks = frame;
  std::erase_if(landmarks.items, [&](const msg::Sighting& sighting) {
    return sighting.object_class == "trash" &&
           Carried::is_carried(in_map(odom, Vec2(sighting.x_m, sighting.y_m)), grippers_m);
  });
  squad.orientation.look(landmarks, now);
  const Viewpoint from = squad.landmarks.update(landmarks, now);
  if (std::ranges::find(frame.items, "robot", &msg::Sighting::object_class) != frame.items.end())
    note_meetings(frame, squad.poses, squad.joint, robots_of_others(squad), now);
  for (Squad* other : squads_.others_near(squad, from.pose.position_m, kPlainViewTo_m))
    other->landmarks.penalize_unseen(landmarks, from);
  look(frame);
}

std::vector<Gaussian2> TeamMap::robots_of_others(const Squad& squad) const {
  std::vector<Gaussian2> others;
  for (const auto& [name, its_squad] : squads_.robots())
    if (its_squad != &squad) others.push_back(its_squad->poses.position(name));
  return others;
}

void TeamMap::look(const msg::Sightings& frame) {
  const RobotPoses& poses = squads_.of(frame.robot).poses;
  const Pose2 pose = poses.pose(frame.robot), odom = poses.frame(frame.robot);
  Pose2& last = heard_[frame.robot].last_looked;
  if ((pose.position_m - last.position_m).norm() < kFloorStep_m &&
      std::abs(wrap_angle(pose.heading_rad - last.heading_rad)) < kFloorTurn_rad)
    return;
  last = pose;
  Floor::View view{pose.position_m, pose.heading_rad, frame.view_angle_rad, {}};
  for (const auto& sighting : frame.items)
    if (sighting.range_m < kMostSightRange_m)
      view.seen_m.push_back(in_map(odom, Vec2(sighting.x_m, sighting.y_m)));
  floor_.looked(view);
}

void TeamMap::note(const msg::Variables& variables, Time now) {
  Heard& robot = heard_[variables.robot];
  robot.at = now;
  robot.senses.note(variables, now);
  if (!squads_.know(variables.robot)) return;
  for (const auto& variable : variables.items) {
    if (!is_obstacle(variable)) continue;
    const auto [touched, is_new] = robot.touched.try_emplace(variable.name, variable.updated);
    if (is_new || std::exchange(touched->second, variable.updated) != variable.updated)
      touch(variables.robot, variable, now);
  }
}

void TeamMap::touch(const std::string& robot, const msg::Variable& obstacle, Time now) {
  Squad& squad = squads_.of(robot);
  const Vec2 at_m = in_map(squad.poses.frame(robot), Vec2(obstacle.values[0], obstacle.values[1]));
  const Gaussian2 place{from_robot(squad.poses.pose(robot), at_m),
                        kTouchDeviation_m * kTouchDeviation_m * Mat2::Identity()};
  squad.landmarks.add_contact("obstacle", robot, place, obstacle.certainty, now);
  floor_.bumped(at_m);
}

void TeamMap::note(const msg::Catalog& catalog, Time now) {
  Heard& robot = heard_[catalog.robot];
  robot.at = now;
  if (auto read = catalog_from_json(catalog.json)) robot.catalog = std::move(read).value();
  if (robot.program) robot.senses.note(*robot.program, robot.catalog);
}

void TeamMap::note(const msg::Program& program, Time now) {
  Heard& robot = heard_[program.robot];
  robot.at = now;
  robot.program = program;
  robot.senses.note(program, robot.catalog);
}

void TeamMap::update(Time now) {
  for (const auto& squad : squads_.all()) squad->landmarks.decay(now);
  align(now);
  for (const auto& squad : squads_.all()) {
    squad->same_things.merge_neighbours();
    squad->extent_m = squad->landmarks.extent_m();
  }
  for (const auto& [name, squad] : squads_.robots()) {
    clear_footprint(name);
    carried_.note(name, heard_[name].senses.holds(now), told_, now);
  }
  auto notes = squads_notes(squads_);
  const auto pairs = same_pairs(notes);
  Neighbours::teach(notes, pairs);
  told_ = united(std::move(notes), pairs);
}

/// It is the dearest part: of many squads one is aligned at a time, and none is forgotten.
void TeamMap::align(Time now) {
  if (squads_.all().empty()) return;
  const auto least = [](const auto& squad) { return squad->aligned; };
  Squad& squad = **std::ranges::min_element(squads_.all(), {}, least);
  if (to_seconds(now - squad.aligned) < kAlignEvery_s) return;
  squad.aligned = now;
  squad.same_things.align(now, squad.placed ? known_to_others(squad, told_) : std::vector<Mark>{});
  neighbours_.find_unplaced(told_);
}

void TeamMap::clear_footprint(const std::string& robot) {
  Squad& squad = squads_.of(robot);
  squad.landmarks.clear_footprint(robot);
  const Gaussian2 at = squad.poses.position(robot);
  for (Squad* other : squads_.others_near(squad, at.mean_m, LandmarkMap::kFootprint_m))
    other->landmarks.clear_footprint(at);
}

}  // namespace galilean::monitor
