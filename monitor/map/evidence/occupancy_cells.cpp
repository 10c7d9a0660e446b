// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/map/evidence/occupancy_cells.h"

#include <mrpt/maps/COccupancyGridMap2D.h>

#include <algorithm>
#include <cmath>

namespace galilean::monitor {
namespace {

/// The probability that a cell is free after one piece of evidence, if nothing was known before.
constexpr float kStoodOn = 0.80F;
constexpr float kLookedAcross = 0.58F;
constexpr float kSawNothing = 0.54F;
constexpr float kTouched = 0.05F;
/// A cell is unknown if its probability of being free is between these.
constexpr float kUnknownAbove = 0.45F;
constexpr float kUnknownBelow = 0.55F;

constexpr float kStartSize_m = 10;

float if_right(float free_probability, double sure) {
  return 0.5F + static_cast<float>(sure) * (free_probability - 0.5F);
}

float log_odds(float p) {
  return std::log(p / (1 - p));
}

float probability_of(float l) {
  return 1 / (1 + std::exp(-l));
}

}  // namespace

struct OccupancyCells::Grid : mrpt::maps::COccupancyGridMap2D {
  explicit Grid(double cell_m)
      : COccupancyGridMap2D(-kStartSize_m / 2, kStartSize_m / 2, -kStartSize_m / 2,
                            kStartSize_m / 2, static_cast<float>(cell_m)) {}
};

OccupancyCells::OccupancyCells(double cell_m, double most_m)
    : most_m_(most_m), cells_(std::make_unique<Grid>(cell_m)) {}
OccupancyCells::~OccupancyCells() = default;

bool OccupancyCells::make_room(const Vec2& at_m) {
  Grid& grid = *cells_;
  if (!at_m.allFinite() || at_m.cwiseAbs().maxCoeff() > most_m_ / 2 - 2 * kMargin_m) return false;
  const auto x = static_cast<float>(at_m.x()), y = static_cast<float>(at_m.y());
  const auto margin = static_cast<float>(kMargin_m);
  if (x - margin < grid.getXMin() || x + margin > grid.getXMax() || y - margin < grid.getYMin() ||
      y + margin > grid.getYMax())
    grid.resizeGrid(std::min(x - margin, grid.getXMin()), std::max(x + margin, grid.getXMax()),
                    std::min(y - margin, grid.getYMin()), std::max(y + margin, grid.getYMax()));
  return true;
}

void OccupancyCells::stand_on(const Vec2& at_m, double sure) {
  Grid& grid = *cells_;
  const int column = grid.x2idx(at_m.x()), row = grid.y2idx(at_m.y());
  grid.updateCell(column, row, if_right(kStoodOn, sure));
  if (grid.getCell(column, row) > kSurelyFree) grid.setCell(column, row, kSurelyFree);
}

bool OccupancyCells::look_across(const Vec2& at_m, Look look, double sure) {
  Grid& grid = *cells_;
  const int column = grid.x2idx(at_m.x()), row = grid.y2idx(at_m.y());
  const float free = grid.getCell(column, row);
  if (look == Look::kAtNothing && free < kUnknownAbove) return false;
  if (free >= kMostByLooks) return true;
  grid.updateCell(column, row,
                  if_right(look == Look::kAtObject ? kLookedAcross : kSawNothing, sure));
  if (grid.getCell(column, row) > kMostByLooks) grid.setCell(column, row, kMostByLooks);
  return true;
}

void OccupancyCells::touch(const Vec2& at_m, double sure) {
  Grid& grid = *cells_;
  const int column = grid.x2idx(at_m.x()), row = grid.y2idx(at_m.y());
  const float before = log_odds(grid.getCell(column, row));
  const float by_looks = std::clamp(before, 0.0F, log_odds(kMostByLooks));
  const float after = before - by_looks + log_odds(if_right(kTouched, sure));
  grid.setCell(column, row, std::max(kSurelyOccupied, probability_of(after)));
}

msg::OccupancyGrid OccupancyCells::message() const {
  const Grid& grid = *cells_;
  msg::OccupancyGrid message;
  message.info.resolution = grid.getResolution();
  message.info.width = grid.getSizeX();
  message.info.height = grid.getSizeY();
  message.info.origin.position.x = grid.getXMin();
  message.info.origin.position.y = grid.getYMin();
  message.info.origin.orientation.w = 1;
  message.data.reserve(grid.getRawMap().size());
  for (const auto raw : grid.getRawMap()) {
    const float free = mrpt::maps::COccupancyGridMap2D::l2p(raw);
    const bool unknown = free > kUnknownAbove && free < kUnknownBelow;
    message.data.push_back(unknown ? std::int8_t{-1}
                                   : static_cast<std::int8_t>(std::lround((1 - free) * 100)));
  }
  return message;
}

}  // namespace galilean::monitor
