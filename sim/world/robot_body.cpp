// SPDX-License-Identifier: BSD-3-Clause
#include "sim/world/robot_body.h"

#include <array>
#include <cmath>

namespace galilean::sim {
namespace {

constexpr int kSwitches = 8;
constexpr double kSwitchForce_n = 2;

b2Body& add_hull(Physics& physics, std::uint16_t index, const Pose2& start) {
  b2BodyDef definition;
  definition.type = b2_dynamicBody;
  definition.position = to_b2(start.position_m);
  definition.angle = static_cast<float>(start.heading_rad);
  definition.allowSleep = false;
  set_tag(definition, {BodyKind::kRobot, index});
  b2Body& body = *physics.world().CreateBody(&definition);
  const b2PolygonShape hull = box_shape({kChassisLength_m, kChassisWidth_m});
  b2FixtureDef fixture;
  fixture.shape = &hull;
  fixture.friction = 0.2f;
  body.CreateFixture(&fixture);
  return body;
}

void set_mass(b2Body& body) {
  b2MassData mass;
  mass.mass = static_cast<float>(Treads::kMass_kg);
  mass.center.SetZero();
  mass.I = static_cast<float>(Treads::kInertia_kgm2);
  body.SetMassData(&mass);
}

/// Returns the switch in this direction: 0 in front, then counter-clockwise every 45 degrees.
int switch_at(const Vec2& in_body) {
  const double eighths = std::atan2(in_body.y(), in_body.x()) / (kPi / 4);
  return (static_cast<int>(std::lround(eighths)) + kSwitches) % kSwitches;
}

}  // namespace

RobotBody::RobotBody(Physics& physics, std::uint16_t index, const Pose2& start, const Slip& slip,
                     Random random)
    : index_(index),
      body_(add_hull(physics, index, start)),
      treads_(slip, random.child("treads")),
      gripper_(physics, body_) {
  set_mass(body_);
}

robot::firmware::Inputs RobotBody::inputs() const {
  return {treads_.left_counts(), treads_.right_counts(), bumpers(), gripper_.beam_broken()};
}

void RobotBody::apply(const robot::firmware::Outputs& outputs) {
  powered_ = outputs.left_pwm != 0 || outputs.right_pwm != 0;
  treads_.set_pwm(broken_.left_wheel ? 0 : outputs.left_pwm,
                  broken_.right_wheel ? 0 : outputs.right_pwm);
  gripper_.set_servo(outputs.gripper_permille);
}

void RobotBody::before_step(double dt_s) {
  const b2Vec2 velocity = body_.GetLocalVector(body_.GetLinearVelocity());
  const BodyVelocity after =
      treads_.step({velocity.x, velocity.y, body_.GetAngularVelocity()}, dt_s);
  body_.SetLinearVelocity(body_.GetWorldVector(to_b2({after.forward_mps, after.left_mps})));
  body_.SetAngularVelocity(static_cast<float>(after.turn_radps));
}

void RobotBody::place(const Pose2& pose) {
  if (const auto held = gripper_.held()) gripper_.forget(*held);
  put(body_, pose);
}

void RobotBody::push(const Vec2& impulse_ns) {
  body_.ApplyLinearImpulseToCenter(to_b2(impulse_ns), true);
}

double RobotBody::speed_after_mps(const Vec2& impulse_ns) const {
  const b2Vec2 velocity_mps = body_.GetLinearVelocity();
  return (Vec2(velocity_mps.x, velocity_mps.y) + impulse_ns / body_.GetMass()).norm();
}

bool RobotBody::after_step(const std::vector<Touch>& touches) {
  press_switches(touches);
  return gripper_.update();
}

void RobotBody::press_switches(const std::vector<Touch>& touches) {
  std::array<double, kSwitches> force_n{};
  std::uint8_t touched = 0;
  for (const Touch& touch : touches) {
    const bool in_hands = touch.other.kind == BodyKind::kPiece && gripper_.held() == touch.other;
    if (touch.robot != index_ || in_hands) continue;
    const int at = switch_at(from_b2(body_.GetLocalPoint(to_b2(touch.point_m))));
    force_n[static_cast<std::size_t>(at)] += touch.force_n;
    touched |= static_cast<std::uint8_t>(1 << at);
  }
  // A pressed switch stays pressed as long as something touches it, however lightly.
  pressed_ &= touched;
  for (int i = 0; i < kSwitches; ++i)
    if (force_n[static_cast<std::size_t>(i)] >= kSwitchForce_n)
      pressed_ |= static_cast<std::uint8_t>(1 << i);
}

}  // namespace galilean::sim
