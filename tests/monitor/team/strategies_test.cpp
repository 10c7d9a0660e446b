// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/team/strategies.h"

#include <gtest/gtest.h>

namespace galilean::monitor {
namespace {

msg::RobotState runs(const std::string& robot, const std::string& hash) {
  msg::RobotState state;
  state.robot = robot;
  state.program_name = hash + ".bhdl";
  state.program_hash = hash;
  return state;
}

msg::Score sheet(double elapsed_s, std::vector<msg::RobotScore> robots) {
  msg::Score score;
  score.elapsed_s = elapsed_s;
  score.points_per_piece = 10;
  score.points_per_collision = -1;
  score.robots = std::move(robots);
  return score;
}

TEST(StrategyTally, CreditsWhatIsCountedToTheProgramThatTheRobotRan) {
  StrategyTally tally;
  tally.note(runs("io", "wander"));
  tally.note(runs("callisto", "wander"));
  tally.note(sheet(0, {{"io", 0, 0}, {"callisto", 0, 0}}));
  tally.note(sheet(60, {{"io", 2, 1}, {"callisto", 1, 0}}));
  tally.note(runs("io", "spin"));
  tally.note(sheet(90, {{"io", 4, 1}, {"callisto", 1, 2}}));

  ASSERT_EQ(tally.strategies().size(), 2U);
  const Strategy& wander = tally.strategies()[0];
  EXPECT_EQ(wander.program_hash, "wander");
  EXPECT_EQ(wander.program_name, "wander.bhdl");
  EXPECT_DOUBLE_EQ(wander.robot_seconds, 60 + 60 + 30);
  EXPECT_EQ(wander.deposited, 3U);
  EXPECT_EQ(wander.collisions, 3U);
  EXPECT_DOUBLE_EQ(wander.points, 27);
  const Strategy& spin = tally.strategies()[1];
  EXPECT_DOUBLE_EQ(spin.robot_seconds, 30);
  EXPECT_EQ(spin.deposited, 2U);
  EXPECT_DOUBLE_EQ(spin.points, 20);
}

TEST(StrategyTally, WhatWasCountedBeforeItListenedIsNobodys) {
  StrategyTally tally;
  tally.note(runs("io", "wander"));
  tally.note(sheet(100, {{"io", 7, 7}}));
  tally.note(sheet(101, {{"io", 7, 7}}));
  ASSERT_EQ(tally.strategies().size(), 1U);
  EXPECT_EQ(tally.strategies()[0].deposited, 0U);
  EXPECT_DOUBLE_EQ(tally.strategies()[0].robot_seconds, 1);
}

TEST(StrategyTally, ARobotOutOfServiceSpendsNoTime) {
  StrategyTally tally;
  auto away = runs("io", "wander");
  away.out_of_service = true;
  tally.note(away);
  tally.note(runs("callisto", "wander"));
  tally.note(sheet(0, {{"io", 0, 0}, {"callisto", 0, 0}}));
  tally.note(sheet(10, {{"io", 0, 0}, {"callisto", 0, 0}}));
  ASSERT_EQ(tally.strategies().size(), 1U);
  EXPECT_DOUBLE_EQ(tally.strategies()[0].robot_seconds, 10);
}

TEST(StrategyTally, AClockThatRunsBackBeginsANewContest) {
  StrategyTally tally;
  tally.note(runs("io", "wander"));
  tally.note(sheet(0, {{"io", 0, 0}}));
  tally.note(sheet(500, {{"io", 5, 0}}));
  tally.note(sheet(0, {{"io", 0, 0}}));
  EXPECT_TRUE(tally.strategies().empty());
}

TEST(StrategyTally, KeepsTheProgramsThatWereCreditedMostRecently) {
  StrategyTally tally;
  constexpr std::size_t kPrograms = 3 * StrategyTally::kMostStrategies;
  const auto score_at = [](double elapsed_s) {
    return sheet(elapsed_s, {{"io", static_cast<unsigned>(elapsed_s), 0}, {"stranger", 0, 0}});
  };
  tally.note(runs("io", "wander"));
  tally.note(score_at(0));
  for (std::size_t i = 0; i < kPrograms; ++i) {
    tally.note(runs("stranger", "invented_" + std::to_string(i)));
    tally.note(score_at(static_cast<double>(i + 1)));
    EXPECT_LE(tally.strategies().size(), StrategyTally::kMostStrategies);
  }
  EXPECT_EQ(tally.dropped(), kPrograms + 1 - StrategyTally::kMostStrategies);
  const Strategy& wander = tally.strategies().front();
  EXPECT_EQ(wander.program_hash, "wander") << "it ran all the time";
  EXPECT_EQ(wander.deposited, kPrograms);
  EXPECT_EQ(tally.strategies().back().program_hash, "invented_" + std::to_string(kPrograms - 1));
}

TEST(StrategyTally, KeepsTheProgramsOfTheRobotsThatWereHeardMostRecently) {
  StrategyTally tally;
  for (std::size_t i = 0; i < 3 * StrategyTally::kMostRobots; ++i) {
    tally.note(runs("io", "wander"));
    tally.note(runs("invented_" + std::to_string(i), "spin"));
  }
  tally.note(sheet(0, {{"io", 0, 0}, {"invented_0", 0, 0}}));
  tally.note(sheet(1, {{"io", 1, 0}, {"invented_0", 1, 0}}));
  ASSERT_EQ(tally.strategies().size(), 1U) << "nobody knows what invented_0 runs any more";
  EXPECT_EQ(tally.strategies()[0].program_hash, "wander");
}

TEST(StrategyTally, ARobotThatIsForgottenIsCreditedNothing) {
  StrategyTally tally;
  tally.note(runs("io", "wander"));
  tally.note(sheet(0, {{"io", 0, 0}}));
  tally.forget("io");
  tally.note(sheet(9, {{"io", 1, 0}}));
  EXPECT_TRUE(tally.strategies().empty());
}

}  // namespace
}  // namespace galilean::monitor
