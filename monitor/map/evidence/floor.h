#pragma once

#include <memory>
#include <vector>

#include "core/geometry.h"
#include "core/wire/messages.h"

namespace galilean::monitor {

/// Which floor is free and which is occupied, in the map frame (mrpt::maps::COccupancyGridMap2D:
/// log-odds of a cell, added up). Grows as robots get further, up to kMostAcross.
///
/// Free is where a robot stood and what its camera looked across: in the direction of a landmark up
/// to that landmark, elsewhere in its field of view for kClear, since a camera that knows landmarks
/// by their colour sees no walls; never beyond what is occupied. Occupied is what was bumped into.
class Floor {
 public:
  static constexpr double kCell_m = 0.05;
  static constexpr double kMostAcross_m = 100;
  static constexpr double kClear_m = 0.8;

  /// What a camera had before it.
  struct View {
    Vec2 from_m = Vec2::Zero();
    double heading_rad = 0;
    double angle_rad = 0;      ///< horizontal field of view
    std::vector<Vec2> seen_m;  ///< landmarks
  };

  Floor();
  ~Floor();

  void stood(const Vec2& robot_m);
  void looked(const View& view);
  void bumped(const Vec2& at_m);

  /// Nothing was noted yet.
  [[nodiscard]] bool empty() const noexcept { return empty_; }
  /// Header and stamps are left to the caller.
  [[nodiscard]] msg::OccupancyGrid grid() const;

 private:
  struct Cells;

  [[nodiscard]] bool make_room(const Vec2& at_m);
  void look_along(const Vec2& from_m, double direction_rad, double length_m,
                  float free_probability);
  void update_disc(const Vec2& centre_m, double radius_m, float free_probability);

  std::unique_ptr<Cells> cells_;
  bool empty_ = true;
};

}  // namespace galilean::monitor
