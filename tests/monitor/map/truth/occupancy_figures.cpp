// SPDX-License-Identifier: BSD-3-Clause
#include "tests/monitor/map/truth/occupancy_figures.h"

#include <cmath>

namespace galilean::monitor {
namespace {

constexpr double kCell_m = OccupancyGridMap::kCell_m;
constexpr double kRay_rad = 0.03;
/// A touched place counts while something solid is this near to it.
constexpr double kStillThere_m = kCell_m;

bool is_free(int value) {
  return value >= 0 && value < 50;
}
bool is_occupied(int value) {
  return value > 50;
}

/// The published grid by positions in the map frame.
class Published {
 public:
  explicit Published(const msg::OccupancyGrid& grid) : grid_(grid) {}

  [[nodiscard]] Vec2 centre_m(std::size_t cell) const {
    const auto column = static_cast<double>(cell % grid_.info.width);
    const auto row = static_cast<double>(cell / grid_.info.width);
    return origin_m() + kCell_m * Vec2(column + 0.5, row + 0.5);
  }
  /// Returns -1 outside of the grid, as where nothing is known.
  [[nodiscard]] int at(const Vec2& at_m) const {
    const Vec2 cell = ((at_m - origin_m()) / kCell_m).array().floor();
    if (cell.minCoeff() < 0 || cell.x() >= grid_.info.width || cell.y() >= grid_.info.height)
      return -1;
    return grid_.data[static_cast<std::size_t>(cell.y()) * grid_.info.width +
                      static_cast<std::size_t>(cell.x())];
  }
  [[nodiscard]] bool is_occupied_near(const Vec2& at_m, double within_m) const {
    for (double dx_m = -within_m; dx_m <= within_m; dx_m += kCell_m / 2)
      for (double dy_m = -within_m; dy_m <= within_m; dy_m += kCell_m / 2)
        if (std::hypot(dx_m, dy_m) <= within_m && is_occupied(at(at_m + Vec2(dx_m, dy_m))))
          return true;
    return false;
  }

 private:
  [[nodiscard]] Vec2 origin_m() const {
    return {grid_.info.origin.position.x, grid_.info.origin.position.y};
  }

  const msg::OccupancyGrid& grid_;
};

}  // namespace

void OccupancyFigures::add(const OccupancyFigures& other) {
  free_precision.add(other.free_precision);
  free_recall.add(other.free_recall);
  occupied_precision.add(other.occupied_precision);
  occupied_recall.add(other.occupied_recall);
}

void OccupancyWatch::Cells::mark(const Vec2& at_m) {
  const Vec2 cell = (at_m / kCell_m).array().floor();
  if (cell.minCoeff() < 0) return;
  const auto column = static_cast<std::size_t>(cell.x()), row = static_cast<std::size_t>(cell.y());
  if (column < columns && row < rows) marked[row * columns + column] = true;
}

std::vector<Vec2> OccupancyWatch::Cells::marked_m() const {
  std::vector<Vec2> centres;
  for (std::size_t i = 0; i < marked.size(); ++i)
    if (marked[i])
      centres.push_back(kCell_m * Vec2(double(i % columns) + 0.5, double(i / columns) + 0.5));
  return centres;
}

OccupancyWatch::OccupancyWatch(MappedContest& contest)
    : contest_(contest), solid_(contest.contest().world()) {
  const sim::ArenaRules& arena = contest.contest().world().scenario().arena;
  known_.columns = static_cast<std::size_t>(std::ceil(arena.width_m / kCell_m));
  known_.rows = static_cast<std::size_t>(std::ceil(arena.depth_m / kCell_m));
  known_.marked.resize(known_.columns * known_.rows);
  touched_ = known_;
  contest.on_step.push_back([this] { note_step(); });
  contest.on_sightings.push_back([this](std::size_t robot, const msg::Sightings& frame) {
    note_seen(robot, frame.view_angle_rad);
  });
}

void OccupancyWatch::note_step() {
  const sim::World& world = contest_.contest().world();
  for (const Vec2& at_m : solid_.touched_m()) touched_.mark(at_m);
  for (std::size_t i = 0; i < world.robot_count(); ++i) {
    const Pose2 pose = world.robot(i).pose();
    for (double x_m = -sim::kChassisLength_m / 2; x_m <= sim::kChassisLength_m / 2;
         x_m += kCell_m / 2)
      for (double y_m = -sim::kChassisWidth_m / 2; y_m <= sim::kChassisWidth_m / 2;
           y_m += kCell_m / 2)
        known_.mark(pose.position_m + rotated({x_m, y_m}, pose.heading_rad));
  }
}

void OccupancyWatch::note_seen(std::size_t robot, double view_angle_rad) {
  const sim::RobotBody& body = contest_.contest().world().robot(robot);
  const Pose2 pose = body.pose();
  for (double off_rad = -view_angle_rad / 2; off_rad <= view_angle_rad / 2; off_rad += kRay_rad) {
    const double direction_rad = pose.heading_rad + off_rad;
    const double seen_m =
        solid_.seen_m(pose.position_m, direction_rad, OccupancyFigures::kSeen_m, body.body());
    for (double away_m = 0; away_m < seen_m; away_m += kCell_m / 2)
      known_.mark(pose.position_m + away_m * unit_vector(direction_rad));
  }
}

OccupancyFigures OccupancyWatch::figures() const {
  OccupancyFigures figures;
  const msg::OccupancyGrid grid = contest_.map().occupancy().message();
  judge_cells(grid, figures);
  judge_places(grid, figures);
  return figures;
}

void OccupancyWatch::judge_cells(const msg::OccupancyGrid& grid, OccupancyFigures& figures) const {
  const Published published(grid);
  for (std::size_t cell = 0; cell < grid.data.size(); ++cell) {
    const Vec2 at_m = published.centre_m(cell);
    if (is_free(grid.data[cell]))
      figures.free_precision.count(solid_.has_floor_near(at_m, OccupancyFigures::kTolerance_m));
    else if (is_occupied(grid.data[cell]))
      figures.occupied_precision.count(solid_.distance_m(at_m) <= OccupancyFigures::kTolerance_m);
  }
}

void OccupancyWatch::judge_places(const msg::OccupancyGrid& grid, OccupancyFigures& figures) const {
  const Published published(grid);
  for (const Vec2& at_m : known_.marked_m())
    if (solid_.distance_m(at_m) > OccupancyFigures::kTolerance_m)
      figures.free_recall.count(is_free(published.at(at_m)));
  for (const Vec2& at_m : touched_.marked_m())
    if (solid_.distance_m(at_m) <= kStillThere_m)
      figures.occupied_recall.count(
          published.is_occupied_near(at_m, OccupancyFigures::kTolerance_m));
}

}  // namespace galilean::monitor
