// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "monitor/logs/figures/map_tracks.h"

namespace galilean::logs {

/// A cell that is at least so occupied counts as occupied, and at most so occupied as free, as in
/// ROS.
inline constexpr int kOccupiedFrom = 65, kFreeTo = 25;

/// The part of the plane that a map shows, with a margin, and its scale.
struct MapExtent {
  double left_m = std::numeric_limits<double>::infinity(), right_m = -left_m;
  double bottom_m = left_m, top_m = -left_m;

  explicit MapExtent(const MapTracks& tracks) {
    constexpr double kMargin_m = 0.25;
    for (const auto& [robot, track] : tracks.tracks)
      for (const auto& point : track.points_m()) include(point);
    for (const auto& thing : tracks.things) include(thing.at_m);
    if (tracks.floor) include(*tracks.floor);
    left_m -= kMargin_m;
    bottom_m -= kMargin_m;
    right_m += kMargin_m;
    top_m += kMargin_m;
  }
  /// Returns whether the extent has a size: places may be further apart than a number can say, or
  /// so far away that a margin is nothing.
  [[nodiscard]] bool is_drawable() const noexcept {
    return std::isfinite(width_m()) && std::isfinite(height_m()) && width_m() > 0 && height_m() > 0;
  }
  [[nodiscard]] double width_m() const noexcept { return right_m - left_m; }
  [[nodiscard]] double height_m() const noexcept { return top_m - bottom_m; }

 private:
  void include(const DrawnPoint& point) noexcept {
    left_m = std::min(left_m, point.x);
    right_m = std::max(right_m, point.x);
    bottom_m = std::min(bottom_m, point.y);
    top_m = std::max(top_m, point.y);
  }
  /// Includes the cells of which something is known.
  void include(const MapFloor& floor) noexcept {
    for (std::size_t i = 0; i < floor.cells.size(); ++i) {
      if (floor.cells[i] < 0) continue;
      const std::size_t column = i % floor.width, row = i / floor.width;
      const double x_m = floor.origin_m.x + static_cast<double>(column) * floor.resolution_m;
      const double y_m = floor.origin_m.y + static_cast<double>(row) * floor.resolution_m;
      include(DrawnPoint{x_m, y_m});
      include(DrawnPoint{x_m + floor.resolution_m, y_m + floor.resolution_m});
    }
  }
};

}  // namespace galilean::logs
