#include "sim/world/objects.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace galilean::sim {
namespace {

constexpr double kBasketMass_kg = 3;
constexpr double kFloorFriction = 0.45;
constexpr double kGravity_mps2 = 9.81;

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
  fixture.density = static_cast<float>(mass_kg / (kPi * radius_m * radius_m));
  body.CreateFixture(&fixture);
  return body;
}

void rub_body(b2Body& body, double dt_s) {
  if (!body.IsAwake()) return;
  const float loss = static_cast<float>(kFloorFriction * kGravity_mps2 * dt_s);
  b2Vec2 velocity = body.GetLinearVelocity();
  const float speed = velocity.Length();
  velocity *= speed > loss ? (speed - loss) / speed : 0.0f;
  body.SetLinearVelocity(velocity);
  body.SetAngularVelocity(body.GetAngularVelocity() * 0.9f);
}

}  // namespace

const PieceShape& shape_of(PieceKind kind) noexcept {
  static constexpr std::array<PieceShape, kPieceKinds> kShapes{
      {{0.033, 0.122, 0.020}, {0.038, 0.095, 0.010}, {0.042, 0.070, 0.012}}};
  return kShapes[static_cast<std::size_t>(kind)];
}

Objects::Objects(const Scenario& scenario, const std::vector<PlacedPiece>& pieces, Physics& physics)
    : physics_(physics) {
  for (const auto& piece : pieces) {
    const BodyTag tag{BodyKind::kPiece, static_cast<std::uint16_t>(pieces_.size())};
    const PieceShape& shape = shape_of(piece.kind);
    pieces_.push_back(
        {piece.kind, &add_disc(physics, tag, piece.position_m, shape.radius_m, shape.mass_kg)});
  }
  for (const Vec2& at : scenario.baskets_m) {
    const BodyTag tag{BodyKind::kBasket, static_cast<std::uint16_t>(baskets_.size())};
    baskets_.push_back(&add_disc(physics, tag, at, kBasketRadius_m, kBasketMass_kg));
  }
}

void Objects::rub(double dt_s) {
  for (auto& piece : pieces_)
    if (piece.body) rub_body(*piece.body, dt_s);
  for (b2Body* basket : baskets_) rub_body(*basket, dt_s);
}

void Objects::remove_piece(std::size_t index) {
  physics_.world().DestroyBody(pieces_[index].body);
  pieces_[index].body = nullptr;
}

}  // namespace galilean::sim
