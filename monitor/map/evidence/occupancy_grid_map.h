// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "core/geometry.h"
#include "core/wire/messages.h"
#include "monitor/map/estimation/gaussian.h"

namespace galilean::monitor {

class OccupancyCells;

/// Which floor is free and which is occupied, in the map frame. The grid grows as robots get
/// further, up to kMaxSize_m.
///
///   free      is where a robot stands, and what its camera looks across: in the direction of an
///             object up to that object, elsewhere in the field of view for kClear_m, because a
///             camera that knows objects by their colour sees no walls
///   occupied  is what a robot touched
///   sure      Evidence counts as far as the robot's place is known: by how likely that place is
///             within half the robot's width of its mean, and a touched one within kTouchKnown_m.
///             What is under the robot's edges counts by how likely the robot covers it. A touch
///             that is less sure than kLeastTouch says nothing
///   source    OccupancyCells says what evidence does to a cell
class OccupancyGridMap {
 public:
  static constexpr double kCell_m = 0.05;
  static constexpr double kMaxSize_m = 100;  ///< of a side
  static constexpr double kClear_m = 0.8;
  static constexpr double kTouchKnown_m = 0.10;
  static constexpr double kLeastTouch = 0.15;

  /// What a camera saw, in the map frame.
  struct View {
    Vec2 from_m = Vec2::Zero();
    double heading_rad = 0;
    double angle_rad = 0;         ///< horizontal field of view
    std::vector<Vec2> objects_m;  ///< positions of the objects that it saw
    double deviation_m = 0;       ///< standard deviation of `from_m`
  };

  OccupancyGridMap();
  ~OccupancyGridMap();

  /// Adds evidence. Positions outside of kMaxSize_m, and those that are not finite, are ignored.
  void add_robot(const Gaussian2& robot, double heading_rad);
  void add_view(const View& view);
  void add_touch(const Gaussian2& touched);

  /// Returns whether there is no evidence yet.
  [[nodiscard]] bool empty() const noexcept { return empty_; }
  /// Returns the grid: 0 (free) to 100 (occupied) for each cell, -1 where it is unknown. The caller
  /// sets header and stamps.
  [[nodiscard]] msg::OccupancyGrid message() const;

 private:
  /// Returns false where the grid cannot grow so far.
  [[nodiscard]] bool make_room(const Vec2& at_m);
  /// Looks for `seen_m` in one direction, or for kClear_m if nothing was seen there.
  void add_line_of_sight(const Vec2& from_m, double direction_rad, std::optional<double> seen_m,
                         double sure);
  /// Calls `update(at_m)` for the cells of a disc.
  void for_each_cell(const Vec2& centre_m, double radius_m, auto&& update);

  std::unique_ptr<OccupancyCells> cells_;
  bool empty_ = true;
};

}  // namespace galilean::monitor
