#pragma once

#include <memory>

#include "core/geometry.h"
#include "core/wire/messages.h"

namespace galilean::monitor {

/// Which floor is free and which is occupied, in the map frame (mrpt::maps::COccupancyGridMap2D:
/// log-odds of a cell, added up). Grows as robots get further, up to kMostAcross.
///
/// Free is where a robot stood and what it looked across to see a thing; a camera that knows things
/// by their colour sees no walls, so what lies beside the sight lines stays unknown. Occupied is
/// what was bumped into.
class Floor {
 public:
  static constexpr double kCell_m = 0.05;
  static constexpr double kMostAcross_m = 100;

  Floor();
  ~Floor();

  void stood(const Vec2& robot_m);
  /// `to_m` is where the thing stands; its own place is not told free.
  void looked(const Vec2& from_m, const Vec2& to_m);
  void bumped(const Vec2& at_m);

  /// Nothing was noted yet.
  [[nodiscard]] bool empty() const noexcept { return empty_; }
  /// Header and stamps are left to the caller.
  [[nodiscard]] msg::OccupancyGrid grid() const;

 private:
  struct Cells;

  [[nodiscard]] bool make_room(const Vec2& at_m);
  void update(const Vec2& at_m, float free_probability);
  void update_disc(const Vec2& centre_m, double radius_m, float free_probability);

  std::unique_ptr<Cells> cells_;
  bool empty_ = true;
};

}  // namespace galilean::monitor
