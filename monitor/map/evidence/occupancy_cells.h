// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>

#include "core/geometry.h"
#include "core/wire/messages.h"

namespace galilean::monitor {

/// The cells of an occupancy grid around the origin of the map frame, and what one piece of
/// evidence does to one of them. Requires of all positions: make_room returned true for one that is
/// nearer than kMargin_m.
///
///   law     A cell holds the log-odds l that it is free, and each piece of evidence adds its own:
///           l += log(p / (1 - p)). Evidence that is right with probability `sure` and says nothing
///           otherwise has p = 1/2 + sure (p - 1/2)
///   looks   make no cell surer than kMostByLooks, because they are not independent: a camera that
///           sees no walls looks across each of them again and again
///   touch   takes back what looks alone said of the cell
///   bounds  No cell becomes surer than kSurelyFree and kSurelyOccupied, so that the map can change
///           its mind
///   source  occupancy grid mapping (Thrun, Burgard, Fox 2005, chapter 9); bounds as in OctoMap
///           (Hornung et al. 2013)
class OccupancyCells {
 public:
  static constexpr double kMargin_m = 1;
  static constexpr float kMostByLooks = 0.80F;
  static constexpr float kSurelyFree = 0.97F;
  static constexpr float kSurelyOccupied = 0.03F;

  /// A look along a line of sight. One that ended at an object saw through whatever is on its way.
  /// Any other ends at the first cell that is occupied.
  enum class Look { kAtObject, kAtNothing };

  OccupancyCells(double cell_m, double most_m);
  ~OccupancyCells();

  /// Returns false if `at_m` is not finite or too near to the edge of the largest grid.
  [[nodiscard]] bool make_room(const Vec2& at_m);

  void stand_on(const Vec2& at_m, double sure);
  /// Returns whether the line of sight goes on.
  bool look_across(const Vec2& at_m, Look look, double sure);
  void touch(const Vec2& at_m, double sure);

  /// Returns the cells without header and stamps.
  [[nodiscard]] msg::OccupancyGrid message() const;

 private:
  struct Grid;

  double most_m_;  ///< of a side
  std::unique_ptr<Grid> cells_;
};

}  // namespace galilean::monitor
