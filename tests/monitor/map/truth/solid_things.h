// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "sim/world/world.h"

namespace galilean::monitor {

/// What a robot cannot drive through: walls, furniture, chairs and baskets, as they stand now. A
/// chair is the square of its legs, which stand closer than a robot is wide. Pieces of trash and
/// robots are none. Positions are in the arena's frame, which is the map's
/// where the map was told the true starts.
class SolidThings {
 public:
  explicit SolidThings(const sim::World& world) : world_(world) {}

  /// Returns how far `from_m` is from the nearest of them [m], and 0 inside of one or outside of
  /// the arena.
  [[nodiscard]] double distance_m(const Vec2& from_m) const;
  /// Returns whether some floor that nothing stands on is within `within_m` of `at_m`.
  [[nodiscard]] bool has_floor_near(const Vec2& at_m, double within_m) const;
  /// Returns how far a robot at `from_m` sees in this direction, at most `most_m`. Other robots
  /// hide the floor as well, and the body `self` does not.
  [[nodiscard]] double seen_m(const Vec2& from_m, double direction_rad, double most_m,
                              const b2Body& self) const;
  /// Returns where robots' hulls touch one of them in this step, as hard as a bumper needs.
  [[nodiscard]] std::vector<Vec2> touched_m() const;

 private:
  [[nodiscard]] double to_chairs_m(const Vec2& from_m) const;

  const sim::World& world_;
};

}  // namespace galilean::monitor
