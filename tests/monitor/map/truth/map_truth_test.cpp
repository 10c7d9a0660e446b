// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "tests/monitor/map/truth/figures.h"
#include "tests/monitor/map/truth/occupancy_figures.h"

namespace galilean::monitor {
namespace {

Figures after(double to_s, MappedContest::Starts starts) {
  Figures all;
  for (const std::uint64_t seed : {1, 2, 3}) {
    MappedContest contest({.seed = seed, .duration_s = to_s, .starts = starts});
    TruthWatch watch(contest, to_s - 20, to_s);
    contest.run([&](const auto& now, const auto& map) { watch.look(now, map); });
    all.add(watch.figures());
  }
  return all;
}

/// A mean of nothing is 0, and would be right whatever the map says.
void expect_enough(const Figures& figures, std::size_t trash) {
  constexpr std::size_t kContests = 3, kRobots = 3, kLooks = 20;
  EXPECT_GE(figures.looks, kContests * kLooks);
  EXPECT_EQ(figures.robot_m2.count, figures.looks * kRobots);
  EXPECT_EQ(figures.dead_reckoning_m2.count, figures.looks * kRobots);
  EXPECT_GE(figures.trash_m2.count, figures.looks * trash);
  EXPECT_GE(figures.real, figures.looks * trash);
  EXPECT_GE(figures.basket_m2.count, figures.looks * 3);
  EXPECT_EQ(figures.baskets_published, figures.baskets_right);
}

/// The covariances say what the errors are: not far too little, and not anything.
void expect_consistent(const Squares& nees) {
  EXPECT_GT(nees.mean(), 0.2);
  EXPECT_LT(nees.mean(), 3);
}

TEST(MapTruth, AfterAMinuteTheMapIsRight) {
  const Figures figures = after(60, MappedContest::Starts::kMeasured);
  expect_enough(figures, 8);
  expect_consistent(figures.robot_nees);
  expect_consistent(figures.trash_nees);
  EXPECT_LT(figures.robot_m2.rms(), 0.15);
  EXPECT_LT(figures.robot_m2.rms(), figures.dead_reckoning_m2.rms() / 3);
  EXPECT_LT(figures.trash_m2.rms(), 0.15);
  EXPECT_GT(figures.recall(), 0.8);
  EXPECT_LT(figures.basket_m2.rms(), 0.15);
}

TEST(MapTruth, AfterThreeMinutesItIsFarBetterThanDeadReckoning) {
  const Figures figures = after(180, MappedContest::Starts::kMeasured);
  expect_enough(figures, 2);
  expect_consistent(figures.robot_nees);
  expect_consistent(figures.trash_nees);
  expect_consistent(figures.basket_nees);
  EXPECT_LT(figures.robot_m2.rms(), 0.10);
  EXPECT_LT(figures.robot_m2.rms(), figures.dead_reckoning_m2.rms() / 3);
  EXPECT_LT(figures.trash_m2.rms(), 0.15);
  EXPECT_GT(figures.recall(), 0.8);
  EXPECT_GT(figures.precision(), 0.9);
  EXPECT_LT(figures.basket_m2.rms(), 0.15);
}

TEST(MapTruth, AfterThreeMinutesTheFloorIsFreeAndOccupiedWhereItIsSaidToBe) {
  OccupancyFigures floor;
  for (const std::uint64_t seed : {1, 2}) {
    MappedContest contest({.seed = seed, .duration_s = 180});
    const OccupancyWatch watch(contest);
    contest.run([](const auto&, const auto&) {});
    floor.add(watch.figures());
  }
  EXPECT_GT(floor.free_recall.all, 10000U);
  EXPECT_GT(floor.occupied_recall.all, 50U);
  EXPECT_GE(floor.free_precision.value(), 0.93);
  EXPECT_GE(floor.free_recall.value(), 0.95);
  EXPECT_GE(floor.occupied_precision.value(), 0.88);
  EXPECT_GE(floor.occupied_recall.value(), 0.90);
}

}  // namespace
}  // namespace galilean::monitor
