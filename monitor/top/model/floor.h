// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "core/wire/messages.h"

namespace galilean::monitor::top {

/// What is known of an occupancy grid, in runs of cells of one row that are alike. A screen is
/// drawn ten times a second, and a grid of some hundred thousand cells comes once a second at most.
class Floor {
 public:
  /// The cells from `first` up to and without `end`.
  struct Run {
    std::uint32_t row = 0, first = 0, end = 0;
    bool occupied = false;  ///< false: free
  };

  /// A grid may have fewer cells than it says.
  explicit Floor(const msg::OccupancyGrid& grid);

  /// Returns the runs, row by row, each row from its first column on.
  [[nodiscard]] const std::vector<Run>& runs() const noexcept { return runs_; }
  /// Returns the number of columns up to the last one of which anything is known.
  [[nodiscard]] std::uint32_t columns() const noexcept { return columns_; }
  /// Returns where the middle of a column or of a row is [m].
  [[nodiscard]] double x_m(std::uint32_t column) const noexcept {
    return x_m_ + (column + 0.5) * resolution_m_;
  }
  [[nodiscard]] double y_m(std::uint32_t row) const noexcept {
    return y_m_ + (row + 0.5) * resolution_m_;
  }

 private:
  double x_m_, y_m_, resolution_m_;
  std::vector<Run> runs_;
  std::uint32_t columns_ = 0;
};

}  // namespace galilean::monitor::top
