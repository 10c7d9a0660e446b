// SPDX-License-Identifier: BSD-3-Clause
#include "sim/world/world.h"

#include <algorithm>
#include <array>
#include <limits>

#include "robot/executive/state_hash.h"
#include "sim/world/arena.h"

namespace galilean::sim {
namespace {

Pose2 jittered(const Pose2& start, const Scenario& scenario, Random& random) {
  const double reach_m = scenario.start_jitter_m;
  const double reach_rad = scenario.start_jitter_rad;
  Pose2 pose = start;
  pose.position_m.x() += random.uniform(-reach_m, reach_m);
  pose.position_m.y() += random.uniform(-reach_m, reach_m);
  pose.heading_rad += random.uniform(-reach_rad, reach_rad);
  return pose;
}

void hash_body(robot::StateHash& hash, const b2Body& body) {
  const b2Vec2 velocity = body.GetLinearVelocity();
  for (const float number : {body.GetPosition().x, body.GetPosition().y, body.GetAngle(),
                             velocity.x, velocity.y, body.GetAngularVelocity()})
    hash.add(static_cast<double>(number));
}

}  // namespace

Result<std::unique_ptr<World>> World::make(const Scenario& scenario, std::size_t robots,
                                           std::uint64_t seed) {
  if (robots > scenario.starts.size())
    return Error{scenario.name + ": robots.starts: has places for " +
                 std::to_string(scenario.starts.size()) + " robots, not for " +
                 std::to_string(robots)};
  const Random random(seed);
  auto pieces = scatter_pieces(scenario, random.child("pieces"));
  if (!pieces) return pieces.error();
  return std::unique_ptr<World>(new World(scenario, pieces.value(), robots, random));
}

World::World(const Scenario& scenario, const std::vector<PlacedPiece>& pieces, std::size_t robots,
             const Random& random)
    : scenario_(scenario),
      objects_(scenario_, pieces, physics_),
      referee_(scenario_.rules, robots) {
  build_arena(scenario_, physics_);
  for (std::size_t i = 0; i < robots; ++i) {
    Random own = random.child(robot_name(i));
    const Pose2 start = jittered(scenario_.starts[i], scenario_, own);
    robots_.push_back(std::make_unique<RobotBody>(physics_, static_cast<std::uint16_t>(i), start,
                                                  scenario_.slip, own.child("body")));
    first_poses_.push_back(start);
  }
}

void World::step() {
  objects_.rub(kStep_s);
  for (auto& robot : robots_) robot->before_step(kStep_s);
  physics_.step(kStep_s);
  for (const Hit& hit : physics_.hits()) referee_.record_collision(hit);
  for (std::size_t i = 0; i < robots_.size(); ++i)
    if (robots_[i]->after_step(physics_.touches())) judge_release(i);
  referee_.advance(kStep_s);
}

void World::judge_release(std::size_t robot) {
  const auto let_go = robots_[robot]->gripper().last_held();
  if (!let_go || let_go->kind != BodyKind::kPiece) return;
  if (!objects_.pieces()[let_go->index].body) return;  // two robots held it; the other was first
  const Vec2 at = from_b2(objects_.pieces()[let_go->index].body->GetPosition());
  if (!referee_.record_release(robot, to_nearest_basket_m(at))) return;
  remove_piece(let_go->index);
}

void World::let_go_of(BodyTag body) {
  for (auto& each : robots_) each->gripper().forget(body);
}

void World::place(b2Body& body, const Pose2& pose) {
  const BodyTag tag = tag_of(body);
  if (tag.kind == BodyKind::kRobot) return robots_[tag.index]->place(pose);
  let_go_of(tag);
  put(body, pose);
}

std::string World::drop(const PlacedPiece& piece) {
  const auto index = static_cast<std::uint16_t>(objects_.add_piece(piece));
  return name_of({BodyKind::kPiece, index});
}

void World::remove_piece(std::size_t index) {
  let_go_of({BodyKind::kPiece, static_cast<std::uint16_t>(index)});
  objects_.remove_piece(index);
}

void World::reset() {
  for (std::size_t i = 0; i < robots_.size(); ++i) robots_[i]->place(first_poses_[i]);
  objects_.reset();
  referee_.reset();
}

double World::to_nearest_basket_m(const Vec2& from_m) const {
  double nearest = std::numeric_limits<double>::infinity();
  for (const b2Body* basket : objects_.baskets())
    nearest = std::min(nearest, (from_b2(basket->GetPosition()) - from_m).norm());
  return nearest;
}

void World::hash_into(robot::StateHash& hash) const {
  for (const auto& robot : robots_) hash_body(hash, robot->body());
  for (const b2Body* basket : objects_.baskets()) hash_body(hash, *basket);
  for (const b2Body* chair : objects_.chairs()) hash_body(hash, *chair);
  for (const auto& piece : objects_.pieces()) {
    hash.add(std::uint64_t{piece.body != nullptr});
    if (piece.body) hash_body(hash, *piece.body);
  }
  hash.add(std::uint64_t{referee_.deposited()});
  hash.add(std::uint64_t{referee_.collisions()});
  hash.add(referee_.elapsed_s());
}

std::string robot_name(std::size_t index) {
  static constexpr std::array<const char*, 16> kMoons{
      "io",     "ganymede", "callisto", "europa", "amalthea", "himalia", "elara",    "pasiphae",
      "sinope", "lysithea", "carme",    "ananke", "leda",     "thebe",   "adrastea", "metis"};
  return index < kMoons.size() ? kMoons[index] : "robot_" + std::to_string(index + 1);
}

}  // namespace galilean::sim
