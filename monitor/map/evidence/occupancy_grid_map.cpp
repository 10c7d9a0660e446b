// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/map/evidence/occupancy_grid_map.h"

#include <mrpt/maps/COccupancyGridMap2D.h>

#include <algorithm>
#include <cmath>

namespace galilean::monitor {
namespace {

/// The probability that a cell is free after one piece of evidence, if nothing was known before.
constexpr float kStoodOn = 0.80F;
constexpr float kLookedAcross = 0.58F;
constexpr float kSawNothing = 0.54F;
constexpr float kBumped = 0.15F;
/// A cell is unknown if its probability of being free is between these.
constexpr float kUnknownAbove = 0.45F;
constexpr float kUnknownBelow = 0.55F;

constexpr double kStartSize_m = 10;
constexpr double kMargin_m = 1;
constexpr double kChassisRadius_m = 0.16;  ///< half of the chassis' narrow side
constexpr double kObstacleRadius_m = 0.08;
constexpr double kObjectRadius_m = 0.10;  ///< a line of sight ends so far before an object
constexpr double kRay_rad = 0.04;

}  // namespace

struct OccupancyGridMap::Cells {
  mrpt::maps::COccupancyGridMap2D grid{
      static_cast<float>(-kStartSize_m / 2), static_cast<float>(kStartSize_m / 2),
      static_cast<float>(-kStartSize_m / 2), static_cast<float>(kStartSize_m / 2),
      static_cast<float>(kCell_m)};

  void update(const Vec2& at_m, float free_probability) {
    grid.updateCell(grid.x2idx(at_m.x()), grid.y2idx(at_m.y()), free_probability);
  }

  /// Returns false if the cell is occupied.
  [[nodiscard]] bool update_unless_occupied(const Vec2& at_m, float free_probability) {
    const int column = grid.x2idx(at_m.x()), row = grid.y2idx(at_m.y());
    if (grid.getCell(column, row) < kUnknownAbove) return false;
    grid.updateCell(column, row, free_probability);
    return true;
  }
};

OccupancyGridMap::OccupancyGridMap() : cells_(std::make_unique<Cells>()) {}
OccupancyGridMap::~OccupancyGridMap() = default;

bool OccupancyGridMap::make_room(const Vec2& at_m) {
  if (!at_m.allFinite() || at_m.cwiseAbs().maxCoeff() > kMaxSize_m / 2 - 2 * kMargin_m)
    return false;
  auto& grid = cells_->grid;
  const auto x = static_cast<float>(at_m.x()), y = static_cast<float>(at_m.y());
  const auto margin = static_cast<float>(kMargin_m);
  if (x - margin < grid.getXMin() || x + margin > grid.getXMax() || y - margin < grid.getYMin() ||
      y + margin > grid.getYMax())
    grid.resizeGrid(std::min(x - margin, grid.getXMin()), std::max(x + margin, grid.getXMax()),
                    std::min(y - margin, grid.getYMin()), std::max(y + margin, grid.getYMax()));
  empty_ = false;
  return true;
}

void OccupancyGridMap::update_disc(const Vec2& centre_m, double radius_m, float free_probability) {
  if (!make_room(centre_m)) return;
  for (double dx_m = -radius_m; dx_m <= radius_m; dx_m += kCell_m)
    for (double dy_m = -radius_m; dy_m <= radius_m; dy_m += kCell_m)
      if (std::hypot(dx_m, dy_m) <= radius_m)
        cells_->update(centre_m + Vec2(dx_m, dy_m), free_probability);
}

void OccupancyGridMap::add_robot(const Vec2& robot_m) {
  update_disc(robot_m, kChassisRadius_m, kStoodOn);
}

void OccupancyGridMap::add_view(const View& view) {
  struct Seen {
    double range_m, azimuth_rad;
  };
  std::vector<Seen> seen;
  for (const auto& object : view.objects_m) {
    const Vec2 at_m = rotated(object - view.from_m, -view.heading_rad);
    seen.push_back({at_m.norm(), std::atan2(at_m.y(), at_m.x())});
  }
  for (double off_rad = -view.angle_rad / 2; off_rad <= view.angle_rad / 2; off_rad += kRay_rad) {
    const double direction_rad = view.heading_rad + off_rad;
    double nearest_m = 0;
    for (const auto& [range_m, azimuth_rad] : seen)
      if (std::abs(azimuth_rad - off_rad) < kRay_rad && (nearest_m == 0 || range_m < nearest_m))
        nearest_m = range_m;
    if (nearest_m > 0)
      add_line_of_sight(view.from_m, direction_rad, nearest_m - kObjectRadius_m, kLookedAcross);
    else
      add_line_of_sight(view.from_m, direction_rad, kClear_m, kSawNothing);
  }
}

void OccupancyGridMap::add_line_of_sight(const Vec2& from_m, double direction_rad, double length_m,
                                         float free_probability) {
  const Vec2 step = kCell_m * unit_vector(direction_rad);
  const auto steps = static_cast<int>(length_m / kCell_m);
  if (steps <= 0 || !make_room(from_m) || !make_room(from_m + steps * step)) return;
  for (int i = 0; i < steps; ++i)
    if (!cells_->update_unless_occupied(from_m + i * step, free_probability)) return;
}

void OccupancyGridMap::add_obstacle(const Vec2& at_m) {
  update_disc(at_m, kObstacleRadius_m, kBumped);
}

msg::OccupancyGrid OccupancyGridMap::message() const {
  const auto& cells = cells_->grid;
  msg::OccupancyGrid message;
  message.info.resolution = cells.getResolution();
  message.info.width = cells.getSizeX();
  message.info.height = cells.getSizeY();
  message.info.origin.position.x = cells.getXMin();
  message.info.origin.position.y = cells.getYMin();
  message.info.origin.orientation.w = 1;
  message.data.reserve(cells.getRawMap().size());
  for (const auto raw : cells.getRawMap()) {
    const float free = mrpt::maps::COccupancyGridMap2D::l2p(raw);
    const bool unknown = free > kUnknownAbove && free < kUnknownBelow;
    message.data.push_back(unknown ? std::int8_t{-1}
                                   : static_cast<std::int8_t>(std::lround((1 - free) * 100)));
  }
  return message;
}

}  // namespace galilean::monitor
