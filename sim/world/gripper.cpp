// SPDX-License-Identifier: BSD-3-Clause
#include "sim/world/gripper.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace galilean::sim {
namespace {

constexpr double kRoot_m = 0.215;  // of the hinges, on the front bumper
constexpr double kRootHalf_m = 0.085;
constexpr double kTipHalf_m = 0.11;
constexpr double kSlipsOut_m = 0.055;  // distance from the pocket's middle
constexpr std::uint16_t kEverybody = 0xFFFF;

b2Fixture* add_hand(b2Body& robot, double side) {
  const Vec2 root(kRoot_m, side * kRootHalf_m);
  const Vec2 tip(Gripper::kReach_m, side * kTipHalf_m);
  const Vec2 along = tip - root;
  const b2PolygonShape shape =
      box_shape({along.norm(), 0.022}, (root + tip) / 2, std::atan2(along.y(), along.x()));
  b2FixtureDef fixture;
  fixture.shape = &shape;
  fixture.friction = 0.2f;
  return robot.CreateFixture(&fixture);
}

const b2CircleShape* circle_of(b2Fixture& fixture) {
  return fixture.GetType() == b2Shape::e_circle
             ? static_cast<const b2CircleShape*>(fixture.GetShape())
             : nullptr;
}

/// Visits every fixture near the beam except those of the robot itself.
template <class Look>
class Query final : public b2QueryCallback {
 public:
  Query(const b2Body& robot, Look look) : robot_(robot), look_(look) {}
  bool ReportFixture(b2Fixture* fixture) override {
    return fixture->GetBody() == &robot_ || look_(*fixture);
  }

 private:
  const b2Body& robot_;
  Look look_;
};

/// Calls `look(fixture)` for each fixture near the beam until it returns false.
template <class Look>
void look_at_beam(const Physics& physics, const b2Body& robot, Look look) {
  const float half = static_cast<float>(Gripper::kHalfWidth_m);
  const float ahead = static_cast<float>(Gripper::kPocket_m);
  const b2Vec2 a = robot.GetWorldPoint({ahead, -half});
  const b2Vec2 b = robot.GetWorldPoint({ahead, half});
  b2AABB box;
  box.lowerBound = b2Min(a, b);
  box.upperBound = b2Max(a, b);
  Query query(robot, look);
  const_cast<Physics&>(physics).world().QueryAABB(&query, box);
}

}  // namespace

Gripper::Gripper(Physics& physics, b2Body& robot) : physics_(physics), robot_(robot) {
  hands_[0] = add_hand(robot, 1);
  hands_[1] = add_hand(robot, -1);
}

Vec2 Gripper::centre_in_robot(b2Fixture& circle) const {
  return from_b2(robot_.GetLocalPoint(circle.GetBody()->GetWorldPoint(circle_of(circle)->m_p)));
}

void Gripper::set_servo(int permille) {
  const bool was_open = open();
  servo_permille_ = std::clamp(permille, 0, 1000);
  if (was_open == open()) return;
  let_hands_touch(open() ? kEverybody : static_cast<std::uint16_t>(kEverybody & ~kGraspable));
  if (open())
    release();
  else if (b2Fixture* circle = circle_in_pocket())
    take(*circle);
}

void Gripper::let_hands_touch(std::uint16_t categories) {
  for (b2Fixture* hand : hands_) {
    b2Filter filter;
    filter.maskBits = categories;
    hand->SetFilterData(filter);
  }
}

bool Gripper::update() {
  if (hold_) {
    const Vec2 offset = centre_in_robot(*held_circle_) - Vec2(kPocket_m, 0);
    if (offset.norm() > kSlipsOut_m) release();
  }
  return std::exchange(released_, false);
}

std::optional<BodyTag> Gripper::held() const {
  if (!hold_) return std::nullopt;
  return tag_of(*hold_->GetBodyB());
}

void Gripper::take(b2Fixture& circle) {
  b2Body& body = *circle.GetBody();
  // The joint works on the bodies' origins. The circle, wherever it is in its body, must come to
  // the pocket, so that the origin's target is shifted.
  const Vec2 origin = from_b2(robot_.GetLocalPoint(body.GetPosition()));
  const Vec2 wanted = origin + Vec2(kPocket_m, 0) - centre_in_robot(circle);
  held_circle_ = &circle;
  b2MotorJointDef joint;
  joint.bodyA = &robot_;
  joint.bodyB = &body;
  joint.linearOffset = to_b2(wanted);
  joint.angularOffset = body.GetAngle() - robot_.GetAngle();
  joint.maxForce = static_cast<float>(kHold_n);
  joint.maxTorque = 0.05f;
  joint.correctionFactor = 0.1f;
  hold_ = static_cast<b2MotorJoint*>(physics_.world().CreateJoint(&joint));
}

void Gripper::release() {
  if (!hold_) return;
  last_held_ = held();
  released_ = true;
  physics_.world().DestroyJoint(hold_);
  hold_ = nullptr;
}

void Gripper::forget(BodyTag body) {
  if (held() != body) return;
  physics_.world().DestroyJoint(hold_);
  hold_ = nullptr;
}

b2Fixture* Gripper::circle_in_pocket() const {
  b2Fixture* nearest = nullptr;
  double nearest_m = kHalfWidth_m;
  look_at_beam(physics_, robot_, [&](b2Fixture& fixture) {
    const b2CircleShape* circle = circle_of(fixture);
    if (!circle || circle->m_radius > kLargest_m) return true;
    const Vec2 at = centre_in_robot(fixture);
    const bool in_beam = std::abs(at.x() - kPocket_m) < circle->m_radius;
    if (in_beam && std::abs(at.y()) < nearest_m) {
      nearest_m = std::abs(at.y());
      nearest = &fixture;
    }
    return true;
  });
  return nearest;
}

bool Gripper::beam_broken() const {
  if (!open()) return hold_ != nullptr;
  b2EdgeShape line;
  const float half = static_cast<float>(kHalfWidth_m);
  const float ahead = static_cast<float>(kPocket_m);
  line.SetTwoSided({ahead, -half}, {ahead, half});
  bool broken = false;
  look_at_beam(physics_, robot_, [&](b2Fixture& fixture) {
    if (const b2CircleShape* circle = circle_of(fixture)) {
      const Vec2 at = centre_in_robot(fixture);
      const double aside_m = std::max(0.0, std::abs(at.y()) - kHalfWidth_m);
      broken = std::hypot(at.x() - kPocket_m, aside_m) < circle->m_radius;
    } else {
      broken = b2TestOverlap(&line, 0, fixture.GetShape(), 0, robot_.GetTransform(),
                             fixture.GetBody()->GetTransform());
    }
    return !broken;
  });
  return broken;
}

}  // namespace galilean::sim
