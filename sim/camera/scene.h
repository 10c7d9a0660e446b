// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "sim/scenario/scenario.h"
#include "sim/world/world.h"

namespace galilean::sim {

struct Colour {
  std::uint8_t red = 0;
  std::uint8_t green = 0;
  std::uint8_t blue = 0;
};

enum class Texture : std::uint8_t {
  kPlain,
  kFolds,  ///< hanging cloth: dark, narrow, irregular shadows from top to bottom
  kPanels  ///< a seam every metre
};

/// A stripe of a face, from one height to another.
struct Band {
  float bottom_m = 0;
  float top_m = 0;
  Colour colour;
  Texture texture = Texture::kPlain;
};

/// An upright rectangle over the line from `a` to `b`, seen from the side where `a` is on the left.
/// Arena frame, metres.
struct Face {
  static constexpr std::size_t kMaxBands = 4;

  Eigen::Vector2f a_m;
  Eigen::Vector2f b_m;
  std::array<Band, kMaxBands> bands;
  std::uint8_t band_count = 0;
  float light = 1;  ///< share of the light that its side gets
};

enum class DiscKind : std::uint8_t { kCan, kCup, kWad, kBasket, kLeg };

/// An upright cylinder on the floor.
struct Disc {
  Eigen::Vector2f at_m;
  float radius_m = 0;
  float height_m = 0;
  DiscKind kind = DiscKind::kCan;
};

/// All that can be seen, by the way in which it is drawn. The arena's walls stand behind all else.
/// Furniture is higher than the camera and hides what stands behind it. The rest is low.
struct Scene {
  std::vector<Face> walls;
  std::vector<Face> furniture;
  std::vector<Face> chair_seats;
  std::vector<Disc> chair_legs;
  std::vector<Light> lights;
  std::vector<Disc> loose;  ///< pieces and baskets
  std::vector<std::array<Face, 4>> robots;
  std::vector<Pose2> robot_poses;
};

/// Returns the scene with everything that never moves.
[[nodiscard]] Scene scene_of(const Scenario& scenario);
/// Copies everything that moves from the world into the scene. Allocates only when it first sees a
/// world.
void look_at(const World& world, Scene& scene);

}  // namespace galilean::sim
