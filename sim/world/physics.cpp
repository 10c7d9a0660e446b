// SPDX-License-Identifier: BSD-3-Clause
#include "sim/world/physics.h"

#include <algorithm>

namespace galilean::sim {
namespace {

constexpr int kVelocityIterations = 8;
constexpr int kPositionIterations = 3;

double closing_speed(b2Contact& contact, const b2WorldManifold& manifold) {
  const b2Vec2 point = manifold.points[0];
  const b2Vec2 a = contact.GetFixtureA()->GetBody()->GetLinearVelocityFromWorldPoint(point);
  const b2Vec2 b = contact.GetFixtureB()->GetBody()->GetLinearVelocityFromWorldPoint(point);
  return std::max(0.0f, b2Dot(a - b, manifold.normal));
}

/// Calls `tell(robot, other)` for each robot of a contact.
template <class Tell>
void for_each_robot(b2Contact& contact, Tell&& tell) {
  const BodyTag a = tag_of(*contact.GetFixtureA()->GetBody());
  const BodyTag b = tag_of(*contact.GetFixtureB()->GetBody());
  if (a.kind == BodyKind::kRobot) tell(a.index, b);
  if (b.kind == BodyKind::kRobot) tell(b.index, a);
}

}  // namespace

BodyTag tag_of(const b2Body& body) noexcept {
  const auto packed = const_cast<b2Body&>(body).GetUserData().pointer;
  return {static_cast<BodyKind>(packed >> 16), static_cast<std::uint16_t>(packed & 0xFFFF)};
}

void set_tag(b2BodyDef& definition, BodyTag tag) noexcept {
  definition.userData.pointer = tag.packed();
}

Pose2 pose_of(const b2Body& body) noexcept {
  return {from_b2(body.GetPosition()), body.GetAngle()};
}

void put(b2Body& body, const Pose2& pose) {
  body.SetTransform(to_b2(pose.position_m), static_cast<float>(pose.heading_rad));
  body.SetLinearVelocity(b2Vec2(0, 0));
  body.SetAngularVelocity(0);
  body.SetAwake(true);
}

b2PolygonShape box_shape(const Vec2& size_m, const Vec2& centre_m, double angle_rad) {
  constexpr double kThinnest_m = 0.001;
  const Vec2 half = (size_m / 2).array() - b2_polygonRadius;
  b2PolygonShape shape;
  shape.SetAsBox(static_cast<float>(std::max(half.x(), kThinnest_m)),
                 static_cast<float>(std::max(half.y(), kThinnest_m)), to_b2(centre_m),
                 static_cast<float>(angle_rad));
  return shape;
}

Physics::Physics() : world_(b2Vec2(0, 0)) {
  world_.SetContactListener(this);
  world_.SetContinuousPhysics(false);  // no body crosses its own size in one step
}

void Physics::step(double dt_s) {
  dt_s_ = dt_s;
  touches_.clear();
  hits_.clear();
  world_.Step(static_cast<float>(dt_s), kVelocityIterations, kPositionIterations);
}

void Physics::BeginContact(b2Contact* contact) {
  b2WorldManifold manifold;
  contact->GetWorldManifold(&manifold);
  const double approach_mps = closing_speed(*contact, manifold);
  for_each_robot(*contact, [&](std::uint16_t robot, BodyTag other) {
    hits_.push_back({robot, other, approach_mps});
  });
}

void Physics::PostSolve(b2Contact* contact, const b2ContactImpulse* impulse) {
  b2WorldManifold manifold;
  contact->GetWorldManifold(&manifold);
  for (int i = 0; i < impulse->count; ++i)
    for_each_robot(*contact, [&](std::uint16_t robot, BodyTag other) {
      touches_.push_back(
          {robot, other, from_b2(manifold.points[i]), impulse->normalImpulses[i] / dt_s_});
    });
}

}  // namespace galilean::sim
