// SPDX-License-Identifier: BSD-3-Clause
#include "sim/world/objects.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace galilean::sim {
namespace {

constexpr double kBasketMass_kg = 3;
constexpr double kChairMass_kg = 4;
constexpr double kFrictionArm_m = 0.15;  // mean distance of a chair's four feet from its middle
constexpr double kFloorFriction = 0.45;

b2Body& add_disc(Physics& physics, BodyTag tag, const Vec2& at_m, double radius_m, double mass_kg) {
  b2BodyDef definition;
  definition.type = b2_dynamicBody;
  definition.position = to_b2(at_m);
  set_tag(definition, tag);
  b2Body& body = *physics.world().CreateBody(&definition);
  b2CircleShape shape;
  shape.m_radius = static_cast<float>(radius_m);
  b2FixtureDef fixture;
  fixture.shape = &shape;
  fixture.friction = 0.3f;
  fixture.filter.categoryBits = tag.kind == BodyKind::kPiece ? kGraspable : kSolid;
  fixture.density = static_cast<float>(mass_kg / (kPi * radius_m * radius_m));
  body.CreateFixture(&fixture);
  return body;
}

double less(double speed, double loss) {
  return std::copysign(std::max(0.0, std::abs(speed) - loss), speed);
}

/// Slows a body by floor friction. `arm_m` is the mean distance from the middle at which the floor
/// rubs, which slows turning.
void apply_floor_friction(b2Body& body, double arm_m, double dt_s) {
  if (!body.IsAwake()) return;
  const double loss = kFloorFriction * kGravity_mps2 * dt_s;
  const Vec2 velocity = from_b2(body.GetLinearVelocity());
  const double speed = velocity.norm();
  body.SetLinearVelocity(speed > loss ? to_b2(velocity * ((speed - loss) / speed)) : b2Vec2(0, 0));
  const double turn_loss = loss * body.GetMass() * arm_m / body.GetInertia();
  body.SetAngularVelocity(static_cast<float>(less(body.GetAngularVelocity(), turn_loss)));
}

}  // namespace

const PieceShape& shape_of(PieceKind kind) noexcept {
  static constexpr std::array<PieceShape, kPieceKinds> kShapes{
      {{0.033, 0.122, 0.020}, {0.038, 0.095, 0.010}, {0.042, 0.070, 0.012}}};
  return kShapes[static_cast<std::size_t>(kind)];
}

Objects::Objects(const Scenario& scenario, const std::vector<PlacedPiece>& pieces, Physics& physics)
    : physics_(physics), first_pieces_(pieces), first_baskets_m_(scenario.baskets_m) {
  for (const auto& piece : pieces) add_piece(piece);
  for (const Vec2& at : scenario.baskets_m) {
    const BodyTag tag{BodyKind::kBasket, static_cast<std::uint16_t>(baskets_.size())};
    baskets_.push_back(&add_disc(physics, tag, at, kBasketRadius_m, kBasketMass_kg));
  }
  // Chairs are numbered after the furniture that is fixed.
  auto number = static_cast<std::uint16_t>(scenario.furniture.size());
  for (const Chair& chair : scenario.chairs) add_chair(chair, number++);
}

void Objects::add_chair(const Chair& chair, std::uint16_t number) {
  b2BodyDef definition;
  definition.type = b2_dynamicBody;
  definition.position = to_b2(chair.pose.position_m);
  definition.angle = static_cast<float>(chair.pose.heading_rad);
  set_tag(definition, {BodyKind::kFurniture, number});
  b2Body& body = *physics_.world().CreateBody(&definition);
  b2CircleShape leg;
  leg.m_radius = static_cast<float>(kChairLegRadius_m);
  b2FixtureDef fixture;
  fixture.shape = &leg;
  fixture.filter.categoryBits = kGraspable;
  const double leg_area_m2 = kPi * kChairLegRadius_m * kChairLegRadius_m;
  fixture.density = static_cast<float>(kChairMass_kg / 4 / leg_area_m2);
  for (const Vec2& at : chair_legs_m(chair.pitch_m)) {
    leg.m_p = to_b2(at);
    body.CreateFixture(&fixture);
  }
  chairs_.push_back(&body);
  first_chairs_.push_back(chair.pose);
}

std::array<Vec2, 4> chair_legs_m(double pitch_m) noexcept {
  const double half = pitch_m / 2;
  return {Vec2(half, half), Vec2(-half, half), Vec2(-half, -half), Vec2(half, -half)};
}

void Objects::rub(double dt_s) {
  for (auto& piece : pieces_)
    if (piece.body) apply_floor_friction(*piece.body, shape_of(piece.kind).radius_m / 2, dt_s);
  for (b2Body* basket : baskets_) apply_floor_friction(*basket, kBasketRadius_m / 2, dt_s);
  for (b2Body* chair : chairs_) apply_floor_friction(*chair, kFrictionArm_m, dt_s);
}

b2Body& Objects::make_piece(const PlacedPiece& piece, std::size_t index) {
  const PieceShape& shape = shape_of(piece.kind);
  return add_disc(physics_, {BodyKind::kPiece, static_cast<std::uint16_t>(index)}, piece.position_m,
                  shape.radius_m, shape.mass_kg);
}

std::size_t Objects::add_piece(const PlacedPiece& piece) {
  pieces_.push_back({piece.kind, &make_piece(piece, pieces_.size())});
  return pieces_.size() - 1;
}

void Objects::reset() {
  for (std::size_t i = first_pieces_.size(); i < pieces_.size(); ++i)
    if (pieces_[i].body) remove_piece(i);
  pieces_.resize(first_pieces_.size());
  for (std::size_t i = 0; i < pieces_.size(); ++i) {
    if (!pieces_[i].body) pieces_[i].body = &make_piece(first_pieces_[i], i);
    put(*pieces_[i].body, {first_pieces_[i].position_m, 0});
  }
  for (std::size_t i = 0; i < baskets_.size(); ++i) put(*baskets_[i], {first_baskets_m_[i], 0});
  for (std::size_t i = 0; i < chairs_.size(); ++i) put(*chairs_[i], first_chairs_[i]);
}

void Objects::remove_piece(std::size_t index) {
  physics_.world().DestroyBody(pieces_[index].body);
  pieces_[index].body = nullptr;
}

}  // namespace galilean::sim
