// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <vector>

#include "core/geometry.h"
#include "core/wire/messages.h"

namespace galilean::monitor {

/// Which floor is free and which is occupied, in the map frame. The grid grows as robots get
/// further, up to kMaxSize_m.
///
///   law     A cell holds the log-odds that it is free, to which each piece of evidence is added.
///   Free
///           is where a robot stood, and what its camera looked across: in the direction of an
///           object up to that object, elsewhere in the field of view for kClear_m, because a
///           camera that knows objects by their colour sees no walls. A line of sight ends at an
///           occupied cell. Occupied is what a robot bumped into
///   source  occupancy grid mapping (Thrun, Burgard, Fox 2005, chapter 9);
///           mrpt::maps::COccupancyGridMap2D
class OccupancyGridMap {
 public:
  static constexpr double kCell_m = 0.05;
  static constexpr double kMaxSize_m = 100;  ///< of a side
  static constexpr double kClear_m = 0.8;

  /// What a camera saw, in the map frame.
  struct View {
    Vec2 from_m = Vec2::Zero();
    double heading_rad = 0;
    double angle_rad = 0;         ///< horizontal field of view
    std::vector<Vec2> objects_m;  ///< positions of the objects that it saw
  };

  OccupancyGridMap();
  ~OccupancyGridMap();

  /// Adds evidence. Positions outside of kMaxSize_m, and those that are not finite, are ignored.
  void add_robot(const Vec2& robot_m);
  void add_view(const View& view);
  void add_obstacle(const Vec2& at_m);

  /// Returns whether there is no evidence yet.
  [[nodiscard]] bool empty() const noexcept { return empty_; }
  /// Returns the grid: 0 (free) to 100 (occupied) for each cell, -1 where it is unknown. The caller
  /// sets header and stamps.
  [[nodiscard]] msg::OccupancyGrid message() const;

 private:
  struct Cells;

  /// Returns false where the grid cannot grow so far.
  [[nodiscard]] bool make_room(const Vec2& at_m);
  void add_line_of_sight(const Vec2& from_m, double direction_rad, double length_m,
                         float free_probability);
  void update_disc(const Vec2& centre_m, double radius_m, float free_probability);

  std::unique_ptr<Cells> cells_;
  bool empty_ = true;
};

}  // namespace galilean::monitor
