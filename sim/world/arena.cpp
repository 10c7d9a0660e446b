// SPDX-License-Identifier: BSD-3-Clause
#include "sim/world/arena.h"

namespace galilean::sim {
namespace {

constexpr double kWallThickness_m = 0.2;

b2Body& add_static(Physics& physics, BodyTag tag, const Pose2& pose, const b2Shape& shape) {
  b2BodyDef definition;
  definition.position = to_b2(pose.position_m);
  definition.angle = static_cast<float>(pose.heading_rad);
  set_tag(definition, tag);
  b2Body& body = *physics.world().CreateBody(&definition);
  body.CreateFixture(&shape, 0);
  return body;
}

void add_walls(const ArenaRules& arena, Physics& physics) {
  const double w = arena.width_m;
  const double d = arena.depth_m;
  const double t = kWallThickness_m;
  const Vec2 along(w + 2 * t, t);
  const Vec2 across(t, d);
  const BodyTag wall{BodyKind::kWall, 0};
  add_static(physics, wall, {{w / 2, -t / 2}, 0}, box_shape(along));
  add_static(physics, wall, {{w / 2, d + t / 2}, 0}, box_shape(along));
  add_static(physics, wall, {{-t / 2, d / 2}, 0}, box_shape(across));
  add_static(physics, wall, {{w + t / 2, d / 2}, 0}, box_shape(across));
}

}  // namespace

void build_arena(const Scenario& scenario, Physics& physics) {
  add_walls(scenario.arena, physics);
  std::uint16_t number = 0;
  for (const auto& box : scenario.furniture)
    add_static(physics, {BodyKind::kFurniture, number++}, box.pose, box_shape(box.size_m));
}

}  // namespace galilean::sim
