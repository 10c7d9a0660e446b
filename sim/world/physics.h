// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <box2d/box2d.h>

#include <cstdint>
#include <vector>

#include "core/geometry.h"

namespace galilean::sim {

inline constexpr double kGravity_mps2 = 9.81;

enum class BodyKind : std::uint8_t { kWall, kFurniture, kBasket, kPiece, kRobot };

/// What a Box2D body is: its kind and its number among those of its kind.
struct BodyTag {
  BodyKind kind = BodyKind::kWall;
  std::uint16_t index = 0;

  [[nodiscard]] std::uint32_t packed() const noexcept {
    return static_cast<std::uint32_t>(kind) << 16 | index;
  }
  bool operator==(const BodyTag&) const = default;
};
/// Box2D categories. Closed hands pass through what they could have closed around, and nothing
/// else: a hand that passed a thin screen would be caught behind it when it opens.
inline constexpr std::uint16_t kSolid = 1;
inline constexpr std::uint16_t kGraspable = 2;

[[nodiscard]] BodyTag tag_of(const b2Body& body) noexcept;
void set_tag(b2BodyDef& definition, BodyTag tag) noexcept;

/// One body that a robot's hull touches in this step.
struct Touch {
  std::uint16_t robot = 0;
  BodyTag other;
  Vec2 point_m = Vec2::Zero();  ///< arena frame
  double force_n = 0;           ///< along the contact's normal
};

/// A touch that began in this step, and how fast the two were closing in.
struct Hit {
  std::uint16_t robot = 0;
  BodyTag other;
  double approach_mps = 0;
};

/// The Box2D world of the floor plan, seen from above: no gravity, metres, kilograms, seconds.
/// Box2D's polygons have a skin of 1 cm. `box_shape` subtracts it, so that sizes are true.
class Physics final : private b2ContactListener {
 public:
  Physics();
  Physics(const Physics&) = delete;
  Physics& operator=(const Physics&) = delete;

  [[nodiscard]] b2World& world() noexcept { return world_; }
  [[nodiscard]] const b2World& world() const noexcept { return world_; }
  void step(double dt_s);

  /// Returns the touches of the last step in Box2D's order, which is the same for the same history.
  [[nodiscard]] const std::vector<Touch>& touches() const noexcept { return touches_; }
  [[nodiscard]] const std::vector<Hit>& hits() const noexcept { return hits_; }

 private:
  void BeginContact(b2Contact* contact) override;
  void PostSolve(b2Contact* contact, const b2ContactImpulse* impulse) override;

  b2World world_;
  double dt_s_ = 0;
  std::vector<Touch> touches_;
  std::vector<Hit> hits_;
};

/// Returns a box of this size around `centre_m` in its body's frame.
[[nodiscard]] b2PolygonShape box_shape(const Vec2& size_m, const Vec2& centre_m = Vec2::Zero(),
                                       double angle_rad = 0);

[[nodiscard]] inline b2Vec2 to_b2(const Vec2& v) noexcept {
  return {static_cast<float>(v.x()), static_cast<float>(v.y())};
}
[[nodiscard]] inline Vec2 from_b2(const b2Vec2& v) noexcept {
  return {v.x, v.y};
}
[[nodiscard]] Pose2 pose_of(const b2Body& body) noexcept;
/// Puts a body at a place, where it stands still.
void put(b2Body& body, const Pose2& pose);

}  // namespace galilean::sim
