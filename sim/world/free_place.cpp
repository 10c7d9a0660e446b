// SPDX-License-Identifier: BSD-3-Clause
#include "sim/world/free_place.h"

namespace galilean::sim {
namespace {

b2Transform transform_of(const Pose2& pose) {
  return {to_b2(pose.position_m), b2Rot(static_cast<float>(pose.heading_rad))};
}

bool overlaps(const b2Body& other, const b2Shape& shape, const b2Transform& at) {
  for (const b2Fixture* fixture = other.GetFixtureList(); fixture; fixture = fixture->GetNext())
    if (b2TestOverlap(fixture->GetShape(), 0, &shape, 0, other.GetTransform(), at)) return true;
  return false;
}

std::optional<BodyTag> first_overlap(const b2World& world, const b2Body* self, const b2Shape& shape,
                                     const b2Transform& at) {
  for (const b2Body* other = world.GetBodyList(); other; other = other->GetNext())
    if (other != self && overlaps(*other, shape, at)) return tag_of(*other);
  return std::nullopt;
}

}  // namespace

std::optional<BodyTag> occupant(const b2World& world, const b2Body& body, const Pose2& pose) {
  for (const b2Fixture* fixture = body.GetFixtureList(); fixture; fixture = fixture->GetNext())
    if (auto found = first_overlap(world, &body, *fixture->GetShape(), transform_of(pose)))
      return found;
  return std::nullopt;
}

std::optional<BodyTag> occupant(const b2World& world, const Vec2& at_m, double radius_m) {
  b2CircleShape disc;
  disc.m_radius = static_cast<float>(radius_m);
  return first_overlap(world, nullptr, disc, transform_of({at_m, 0}));
}

}  // namespace galilean::sim
