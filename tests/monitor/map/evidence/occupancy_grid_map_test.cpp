// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/map/evidence/occupancy_grid_map.h"

#include <gtest/gtest.h>

namespace galilean::monitor {
namespace {

constexpr double kSure_m = 0.03, kHalfSure_m = 0.08, kUnsure_m = 0.4;
constexpr double kCell_m = OccupancyGridMap::kCell_m;

Gaussian2 known_to(const Vec2& at_m, double deviation_m) {
  return {at_m, deviation_m * deviation_m * Mat2::Identity()};
}

class OccupancyGridMapTest : public testing::Test {
 protected:
  /// Returns what is published of the cell: 0 (free) to 100 (occupied), -1 where it is unknown.
  [[nodiscard]] int at(const Vec2& at_m) const {
    const auto grid = map.message();
    const Vec2 origin_m(grid.info.origin.position.x, grid.info.origin.position.y);
    const Vec2 cell = (at_m - origin_m) / kCell_m;
    return grid.data.at(static_cast<std::size_t>(cell.y()) * grid.info.width +
                        static_cast<std::size_t>(cell.x()));
  }
  void touch(const Vec2& at_m, double deviation_m) { map.add_touch(known_to(at_m, deviation_m)); }
  void drive(double from_x_m, double to_x_m, double deviation_m) {
    for (double x_m = from_x_m; x_m <= to_x_m; x_m += kCell_m)
      map.add_robot(known_to({x_m, 0}, deviation_m), 0);
  }
  /// A camera at the origin looks along x.
  void look(int times, double deviation_m, const std::vector<Vec2>& objects_m = {}) {
    for (int i = 0; i < times; ++i)
      map.add_view({.angle_rad = 1.2, .objects_m = objects_m, .deviation_m = deviation_m});
  }

  OccupancyGridMap map;
  const Vec2 ahead_m{0.52, 0.02};
};

TEST_F(OccupancyGridMapTest, WhereARobotTouchedSomethingIsOccupied) {
  touch(ahead_m, kSure_m);
  EXPECT_GT(at(ahead_m), 80);
  EXPECT_EQ(at(ahead_m + Vec2(0.2, 0)), -1);
}

TEST_F(OccupancyGridMapTest, ATouchByARobotOfUnknownPlacePaintsNothing) {
  touch(ahead_m, kUnsure_m);
  EXPECT_EQ(at(ahead_m), -1);
}

TEST_F(OccupancyGridMapTest, ATouchByARobotOfUnknownPlaceTakesNothingBack) {
  look(100, kSure_m);
  const int before = at(ahead_m);
  touch(ahead_m, kUnsure_m);
  EXPECT_EQ(at(ahead_m), before);
}

TEST_F(OccupancyGridMapTest, ATouchCountsLessTheLessItsPlaceIsKnown) {
  int before = 100;
  for (const double deviation_m : {0.02, 0.06, 0.1}) {
    touch({deviation_m * 10, 0}, deviation_m);
    const int now = at({deviation_m * 10, 0});
    EXPECT_LT(now, before);
    before = now;
  }
}

TEST_F(OccupancyGridMapTest, ATouchOutweighsWhateverCamerasSaw) {
  look(100, kSure_m);
  EXPECT_LT(at(ahead_m), 25);
  touch(ahead_m, kHalfSure_m);
  EXPECT_GT(at(ahead_m), 60);
}

TEST_F(OccupancyGridMapTest, HoweverOftenACameraLooksItMakesNothingSurerThanLooksMay) {
  constexpr int kLeast = 20;  // 100 (1 - OccupancyCells::kMostByLooks)
  for (const double deviation_m : {0.01, 0.02, 0.03, 0.05}) {
    look(100, deviation_m);
    look(100, deviation_m, {{1.5, 0.06}});
    EXPECT_EQ(at(ahead_m), kLeast) << deviation_m;
  }
}

TEST_F(OccupancyGridMapTest, ACameraLooksNoFurtherThanWhatIsOccupied) {
  touch({0.52, 0}, kSure_m);
  look(100, kSure_m);
  EXPECT_GT(at({0.52, 0.02}), 80);
  EXPECT_EQ(at({0.72, 0.02}), -1);
}

TEST_F(OccupancyGridMapTest, ACameraThatSeesAnObjectSawThroughWhatIsOnItsWay) {
  touch({0.52, 0}, kSure_m);
  look(200, kSure_m, {{1.5, 0.06}});
  EXPECT_LT(at({0.52, 0.02}), 45);
}

TEST_F(OccupancyGridMapTest, WhereARobotDrivesIsFreeWhateverWasTouchedThere) {
  for (int i = 0; i < 50; ++i) touch(ahead_m, kSure_m);
  drive(0.4, 0.6, kSure_m);
  EXPECT_LT(at(ahead_m), 20);
}

TEST_F(OccupancyGridMapTest, ATouchChangesTheMindOfAMapThatWasCrossedOften) {
  for (int i = 0; i < 50; ++i) drive(0, 1, kSure_m);
  EXPECT_LT(at(ahead_m), 10);
  touch(ahead_m, kSure_m);
  EXPECT_GT(at(ahead_m), 55);
}

TEST_F(OccupancyGridMapTest, WhatIsUnderARobotsEdgesIsLessSurelyFree) {
  map.add_robot(known_to({0, 0}, kHalfSure_m), 0);
  EXPECT_LT(at({0.02, 0.02}), at({0.02, 0.14}));
  EXPECT_LT(at({0.02, 0.02}), at({0.18, 0.02}));
  EXPECT_EQ(at({0.02, 0.22}), -1);
}

TEST_F(OccupancyGridMapTest, ARobotOfUnknownPlaceFreesNothing) {
  touch(ahead_m, kSure_m);
  drive(0, 1, 4 * kUnsure_m);
  EXPECT_GT(at(ahead_m), 55);
}

TEST_F(OccupancyGridMapTest, ACameraOfUnknownPlaceSeesNothing) {
  look(100, 4 * kUnsure_m);
  EXPECT_EQ(at(ahead_m), -1);
}

}  // namespace
}  // namespace galilean::monitor
