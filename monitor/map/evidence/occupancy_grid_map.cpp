// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/map/evidence/occupancy_grid_map.h"

#include <algorithm>
#include <cmath>

#include "monitor/map/evidence/occupancy_cells.h"

namespace galilean::monitor {
namespace {

/// Half of the chassis' length and width.
constexpr double kHalfLength_m = 0.215;
constexpr double kHalfWidth_m = 0.165;
constexpr double kTouchedRadius_m = 0.08;
constexpr double kObjectRadius_m = 0.10;  ///< a line of sight ends so far before an object
constexpr double kRay_rad = 0.04;
constexpr double kLeastDeviation_m = 0.01;

/// Returns the standard deviation of a position [m], averaged over all directions.
double deviation_of(const Gaussian2& position) {
  return std::max(kLeastDeviation_m, std::sqrt(position.covariance_m2.trace() / 2));
}

/// Returns how likely a position is within `radius_m` of its mean.
double share_within(double radius_m, double deviation_m) {
  return 1 - std::exp(-radius_m * radius_m / (2 * deviation_m * deviation_m));
}

/// Returns the share of a normal distribution below so many standard deviations above its mean.
double share_below(double deviations) {
  return std::erfc(-deviations / std::sqrt(2)) / 2;
}

/// An object as a camera sees it.
struct Seen {
  double range_m, azimuth_rad;
};

std::vector<Seen> seen_in(const OccupancyGridMap::View& view) {
  std::vector<Seen> seen;
  for (const auto& object : view.objects_m) {
    const Vec2 at_m = rotated(object - view.from_m, -view.heading_rad);
    seen.push_back({at_m.norm(), std::atan2(at_m.y(), at_m.x())});
  }
  return seen;
}

std::optional<double> nearest_at(const std::vector<Seen>& seen, double azimuth_rad) {
  std::optional<double> nearest;
  for (const Seen& object : seen)
    if (std::abs(object.azimuth_rad - azimuth_rad) < kRay_rad)
      nearest = std::min(object.range_m, nearest.value_or(object.range_m));
  return nearest;
}

}  // namespace

OccupancyGridMap::OccupancyGridMap()
    : cells_(std::make_unique<OccupancyCells>(kCell_m, kMaxSize_m)) {}
OccupancyGridMap::~OccupancyGridMap() = default;

bool OccupancyGridMap::make_room(const Vec2& at_m) {
  if (!cells_->make_room(at_m)) return false;
  empty_ = false;
  return true;
}

void OccupancyGridMap::for_each_cell(const Vec2& centre_m, double radius_m, auto&& update) {
  if (!make_room(centre_m)) return;
  for (double dx_m = -radius_m; dx_m <= radius_m; dx_m += kCell_m)
    for (double dy_m = -radius_m; dy_m <= radius_m; dy_m += kCell_m)
      if (std::hypot(dx_m, dy_m) <= radius_m) update(centre_m + Vec2(dx_m, dy_m));
}

void OccupancyGridMap::add_robot(const Gaussian2& robot, double heading_rad) {
  const double deviation_m = deviation_of(robot);
  const double sure = share_within(kHalfWidth_m, deviation_m);
  for_each_cell(robot.mean_m, std::hypot(kHalfLength_m, kHalfWidth_m), [&](const Vec2& at_m) {
    const Vec2 in_robot_m = rotated(at_m - robot.mean_m, -heading_rad).cwiseAbs();
    const double inside_m = (Vec2(kHalfLength_m, kHalfWidth_m) - in_robot_m).minCoeff();
    if (inside_m >= 0) cells_->stand_on(at_m, sure * share_below(inside_m / deviation_m));
  });
}

void OccupancyGridMap::add_view(const View& view) {
  const double sure = share_within(kHalfWidth_m, std::max(kLeastDeviation_m, view.deviation_m));
  const auto seen = seen_in(view);
  // No camera sees more than all around it. An angle that is no number shows nothing.
  const double half_rad = std::min(view.angle_rad / 2, kPi);
  for (double off_rad = -half_rad; off_rad <= half_rad; off_rad += kRay_rad)
    add_line_of_sight(view.from_m, view.heading_rad + off_rad, nearest_at(seen, off_rad), sure);
}

void OccupancyGridMap::add_line_of_sight(const Vec2& from_m, double direction_rad,
                                         std::optional<double> seen_m, double sure) {
  const Vec2 step = kCell_m * unit_vector(direction_rad);
  const double length_m = seen_m ? *seen_m - kObjectRadius_m : kClear_m;
  // A camera sees nothing from farther away than the map is large, and a place that is no number is
  // not seen at all.
  if (!(length_m > 0 && length_m < kMaxSize_m)) return;
  const auto steps = static_cast<int>(length_m / kCell_m);
  if (steps <= 0 || !make_room(from_m) || !make_room(from_m + steps * step)) return;
  const auto look = seen_m ? OccupancyCells::Look::kAtObject : OccupancyCells::Look::kAtNothing;
  for (int i = 0; i < steps; ++i)
    if (!cells_->look_across(from_m + i * step, look, sure)) return;
}

void OccupancyGridMap::add_touch(const Gaussian2& touched) {
  const double sure = share_within(kTouchKnown_m, deviation_of(touched));
  if (sure < kLeastTouch) return;
  for_each_cell(touched.mean_m, kTouchedRadius_m,
                [&](const Vec2& at_m) { cells_->touch(at_m, sure); });
}

msg::OccupancyGrid OccupancyGridMap::message() const {
  return cells_->message();
}

}  // namespace galilean::monitor
