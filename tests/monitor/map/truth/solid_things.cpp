// SPDX-License-Identifier: BSD-3-Clause
#include "tests/monitor/map/truth/solid_things.h"

#include <box2d/b2_distance.h>

#include <algorithm>
#include <limits>

namespace galilean::monitor {
namespace {

/// A bumper needs this force [N]; see sim/world/robot_body.cpp.
constexpr double kSwitchForce_n = 2;

bool is_solid(const b2Body& body) {
  const sim::BodyKind kind = sim::tag_of(body).kind;
  return kind != sim::BodyKind::kPiece && kind != sim::BodyKind::kRobot;
}

double gap_m(const b2Fixture& fixture, const b2Transform& at, const b2Vec2& from) {
  b2DistanceInput input;
  const b2CircleShape point;
  input.proxyA.Set(fixture.GetShape(), 0);
  input.proxyB.Set(&point, 0);
  input.transformA = at;
  input.transformB.Set(from, 0);
  input.useRadii = false;
  b2SimplexCache cache;
  cache.count = 0;
  b2DistanceOutput output;
  b2Distance(&output, &cache, &input);
  return std::max(0.0, static_cast<double>(output.distance) - fixture.GetShape()->m_radius);
}

/// How far a ray goes until it meets a body that hides the floor.
class Sight final : public b2RayCastCallback {
 public:
  explicit Sight(const b2Body& self) : self_(self) {}
  [[nodiscard]] double share() const noexcept { return share_; }

 private:
  float ReportFixture(b2Fixture* fixture, const b2Vec2&, const b2Vec2&, float share) override {
    constexpr float kIgnored = -1;
    const b2Body& body = *fixture->GetBody();
    if (&body == &self_ || sim::tag_of(body).kind == sim::BodyKind::kPiece) return kIgnored;
    share_ = share;
    return share;
  }

  const b2Body& self_;
  double share_ = 1;
};

bool is_touch(const b2Contact& contact) {
  const b2Body& a = *contact.GetFixtureA()->GetBody();
  const b2Body& b = *contact.GetFixtureB()->GetBody();
  const bool a_robot = sim::tag_of(a).kind == sim::BodyKind::kRobot;
  const bool b_robot = sim::tag_of(b).kind == sim::BodyKind::kRobot;
  return contact.IsTouching() && ((a_robot && is_solid(b)) || (b_robot && is_solid(a)));
}

}  // namespace

double SolidThings::distance_m(const Vec2& from_m) const {
  const sim::ArenaRules& arena = world_.scenario().arena;
  if (from_m.minCoeff() <= 0 || from_m.x() >= arena.width_m || from_m.y() >= arena.depth_m)
    return 0;
  double nearest_m = std::numeric_limits<double>::infinity();
  for (const b2Body* body = world_.bodies().GetBodyList(); body; body = body->GetNext()) {
    if (!is_solid(*body)) continue;
    for (const b2Fixture* part = body->GetFixtureList(); part; part = part->GetNext())
      nearest_m = std::min(nearest_m, gap_m(*part, body->GetTransform(), sim::to_b2(from_m)));
  }
  return std::min(nearest_m, to_chairs_m(from_m));
}

double SolidThings::to_chairs_m(const Vec2& from_m) const {
  double nearest_m = std::numeric_limits<double>::infinity();
  const auto& chairs = world_.objects().chairs();
  for (std::size_t i = 0; i < chairs.size(); ++i) {
    const double half_m = world_.scenario().chairs[i].pitch_m / 2 + sim::kChairLegRadius_m;
    const Vec2 in_chair_m = sim::from_b2(chairs[i]->GetLocalPoint(sim::to_b2(from_m)));
    nearest_m =
        std::min(nearest_m, (in_chair_m.cwiseAbs().array() - half_m).max(0).matrix().norm());
  }
  return nearest_m;
}

bool SolidThings::has_floor_near(const Vec2& at_m, double within_m) const {
  constexpr int kDirections = 16;
  if (distance_m(at_m) > 0) return true;
  for (const double away_m : {within_m / 2, within_m})
    for (int i = 0; i < kDirections; ++i)
      if (distance_m(at_m + away_m * unit_vector(2 * kPi * i / kDirections)) > 0) return true;
  return false;
}

double SolidThings::seen_m(const Vec2& from_m, double direction_rad, double most_m,
                           const b2Body& self) const {
  Sight sight(self);
  world_.bodies().RayCast(&sight, sim::to_b2(from_m),
                          sim::to_b2(from_m + most_m * unit_vector(direction_rad)));
  return sight.share() * most_m;
}

std::vector<Vec2> SolidThings::touched_m() const {
  std::vector<Vec2> points;
  for (const b2Contact* contact = world_.bodies().GetContactList(); contact;
       contact = contact->GetNext()) {
    if (!is_touch(*contact)) continue;
    const b2Manifold& manifold = *contact->GetManifold();
    b2WorldManifold in_world;
    contact->GetWorldManifold(&in_world);
    for (int i = 0; i < manifold.pointCount; ++i)
      if (manifold.points[i].normalImpulse >= kSwitchForce_n * sim::World::kStep_s)
        points.push_back(sim::from_b2(in_world.points[i]));
  }
  return points;
}

}  // namespace galilean::monitor
