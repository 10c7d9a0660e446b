// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/top/model/floor.h"

#include <gmock/gmock.h>

#include <array>

namespace galilean::monitor::top {
namespace {

/// A run as row, first column, end and whether it is occupied.
using Numbers = std::array<std::uint32_t, 4>;

std::vector<Numbers> runs_of(const msg::OccupancyGrid& grid) {
  std::vector<Numbers> runs;
  const Floor floor(grid);
  for (const auto& run : floor.runs())
    runs.push_back({run.row, run.first, run.end, run.occupied ? 1U : 0U});
  return runs;
}

msg::OccupancyGrid grid_of(std::uint32_t width, std::vector<std::int8_t> percents) {
  msg::OccupancyGrid grid;
  grid.info.width = width;
  grid.info.height = 2;
  grid.info.resolution = 0.5F;
  grid.info.origin.position.x = -1;
  grid.data = std::move(percents);
  return grid;
}

TEST(Floor, IsWhatIsKnownInRunsOfOneRow) {
  const auto grid = grid_of(5, {-1, 0, 35, 65, 36, 0, 100, 100, -1, 64});
  EXPECT_EQ(runs_of(grid),
            (std::vector<Numbers>{{0, 1, 3, 0}, {0, 3, 4, 1}, {1, 0, 1, 0}, {1, 1, 3, 1}}));
  EXPECT_EQ(Floor(grid).columns(), 4U);
  EXPECT_EQ(Floor(grid).x_m(1), -0.25);
  EXPECT_EQ(Floor(grid).y_m(1), 0.75);
}

TEST(Floor, HasNoCellsThatItsGridHasNot) {
  EXPECT_EQ(runs_of(grid_of(3, {0, 0, 0, 0})), (std::vector<Numbers>{{0, 0, 3, 0}, {1, 0, 1, 0}}));
  EXPECT_EQ(runs_of(grid_of(4'000'000'000U, {0})), (std::vector<Numbers>{{0, 0, 1, 0}}));
  EXPECT_TRUE(runs_of(grid_of(0, {0, 0})).empty());
  EXPECT_TRUE(runs_of(grid_of(1, {0, 0, 0})).size() == 2);
}

}  // namespace
}  // namespace galilean::monitor::top
