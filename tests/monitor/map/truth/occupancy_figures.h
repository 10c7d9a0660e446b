// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include "tests/monitor/map/truth/mapped_contest.h"
#include "tests/monitor/map/truth/solid_things.h"

namespace galilean::monitor {

/// How many of some things are as they should be.
struct Share {
  std::size_t right = 0;
  std::size_t all = 0;

  void count(bool is_right) {
    right += is_right;
    ++all;
  }
  void add(const Share& other) {
    right += other.right;
    all += other.all;
  }
  [[nodiscard]] double value() const { return all ? double(right) / double(all) : 1; }
};

/// How well the published floor agrees with the world at one moment. SolidThings says what is
/// solid. Cells are taken at their centres, and those that are published as unknown count as
/// neither free nor occupied.
///
///   free precision      of the cells that are free, those with floor within kTolerance_m
///   free recall         of the floor that robots drove over or saw, those cells that are free. It
///                       counts what is further than kTolerance_m from anything solid. Seen is what
///                       is in a camera's field of view, nearer than kSeen_m and not hidden
///   occupied precision  of the cells that are occupied, those with a solid thing within
///                       kTolerance_m
///   occupied recall     of the places where a robot touched a solid thing, hard enough for a
///                       bumper, those with an occupied cell within kTolerance_m. It counts places
///                       where that thing still stands
struct OccupancyFigures {
  static constexpr double kTolerance_m = 0.10;
  static constexpr double kSeen_m = OccupancyGridMap::kClear_m;

  Share free_precision, free_recall, occupied_precision, occupied_recall;

  void add(const OccupancyFigures& other);
};

/// Remembers what the robots of a contest could know of the floor. Requires: it was made before the
/// contest runs, and the contest outlives it.
class OccupancyWatch {
 public:
  explicit OccupancyWatch(MappedContest& contest);
  OccupancyWatch(const OccupancyWatch&) = delete;
  OccupancyWatch& operator=(const OccupancyWatch&) = delete;
  /// Compares the map with the world as both are now.
  [[nodiscard]] OccupancyFigures figures() const;

 private:
  /// The arena in cells as large as the map's.
  struct Cells {
    std::size_t columns = 0, rows = 0;
    std::vector<bool> marked;

    void mark(const Vec2& at_m);
    [[nodiscard]] std::vector<Vec2> marked_m() const;
  };

  void note_step();
  void note_seen(std::size_t robot, double view_angle_rad);
  void judge_cells(const msg::OccupancyGrid& grid, OccupancyFigures& figures) const;
  void judge_places(const msg::OccupancyGrid& grid, OccupancyFigures& figures) const;

  const MappedContest& contest_;
  SolidThings solid_;
  Cells known_;    ///< what robots drove over or saw
  Cells touched_;  ///< where they touched something solid
};

}  // namespace galilean::monitor
