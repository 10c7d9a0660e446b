// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "tests/monitor/map/truth/figures.h"

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

TEST(MapTruth, AfterAMinuteTheMapIsRight) {
  const Figures figures = after(60, MappedContest::Starts::kMeasured);
  EXPECT_LT(figures.robot_m2.rms(), 0.15);
  EXPECT_LT(figures.robot_m2.rms(), figures.dead_reckoning_m2.rms() / 3);
  EXPECT_LT(figures.trash_m2.rms(), 0.15);
  EXPECT_GT(figures.recall(), 0.8);
  EXPECT_LT(figures.basket_m2.rms(), 0.15);
}

TEST(MapTruth, AfterThreeMinutesItIsFarBetterThanDeadReckoning) {
  const Figures figures = after(180, MappedContest::Starts::kMeasured);
  EXPECT_LT(figures.robot_m2.rms(), 0.10);
  EXPECT_LT(figures.robot_m2.rms(), figures.dead_reckoning_m2.rms() / 3);
  EXPECT_LT(figures.trash_m2.rms(), 0.15);
  EXPECT_GT(figures.recall(), 0.8);
  EXPECT_GT(figures.precision(), 0.9);
}

}  // namespace
}  // namespace galilean::monitor
