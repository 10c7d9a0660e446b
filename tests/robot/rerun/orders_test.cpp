// SPDX-License-Identifier: BSD-3-Clause
// All that operators, other robots and pushes do to a robot is among the inputs of its ticks.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "robot/inputs/input_digests.h"
#include "tests/robot/executive/branching_robot.h"
#include "tests/robot/rerun/live_robot.h"

namespace galilean::robot {
namespace {

using testing::HasSubstr;

TEST(RerunOfOrders, HoldsStepsAndPushesAreRepeated) {
  LiveRobot robot;
  robot.load(branching_text());
  robot.tick(3);
  robot.executive.hold();
  robot.tick(2);
  EXPECT_TRUE(robot.recorder.ticks.back().outcome.stops);
  robot.executive.resume();
  robot.tick(2);
  EXPECT_FALSE(robot.recorder.ticks.back().outcome.stops);
  EXPECT_TRUE(robot.executive.step());
  robot.executive.push_bumper(0);
  robot.tick(3);
  EXPECT_EQ(robot.state(), "grab");
  EXPECT_TRUE(robot.executive.held()) << "the step is over";
  robot.executive.resume();
  EXPECT_TRUE(robot.executive.stop_with_team());
  robot.tick(8);
  robot.executive.resume();
  robot.executive.decommission();
  robot.go_by(2);
  robot.executive.commission();
  robot.tick(3);
  EXPECT_EQ(robot.state(), "wander");
  expect_same(robot);
  expect_same_from_memories(robot);
}

TEST(RerunOfOrders, BreakPointsLocksAndPassesAreRepeated) {
  LiveRobot robot;
  robot.load(branching_text());
  auto& breaks = robot.executive.breaks();
  ASSERT_TRUE(
      breaks.set({{{"wander", "grab"}, BreakKind::kLock}, {{"", "rest"}, BreakKind::kStop}}));
  robot.tick();
  robot.go_by(0);
  EXPECT_EQ(robot.state(), "wander") << "locked";
  ASSERT_TRUE(breaks.let_through({{"wander", "grab"}}, "wander"));
  robot.go_by(0);
  EXPECT_EQ(robot.state(), "grab");
  robot.go_by(2);
  robot.go_by(1);
  EXPECT_TRUE(robot.executive.held()) << "stopped";
  breaks.clear();
  robot.executive.resume();
  robot.tick(3);
  expect_same(robot);
  expect_same_from_memories(robot);
}

TEST(RerunOfOrders, SwapsAndRollbacksAreRepeated) {
  LiveRobot robot;
  robot.load(branching_text());
  robot.tick(3);
  robot.go_by(0);
  const ProgramId second = robot.load(branching_text("roam"));
  robot.tick(5);
  ASSERT_EQ(robot.executive.running(), second);
  ASSERT_TRUE(robot.executive.roll_back(second, "it went astray"));
  robot.tick(3);
  ASSERT_NE(robot.executive.running(), second);
  const ProgramId third = robot.load(branching_text("roam"));
  robot.tick(2);
  robot.stopwatch.each = std::chrono::milliseconds(60);  // longer than a tick may take
  robot.tick(5);
  EXPECT_NE(robot.executive.running(), third) << "it failed its probation";
  expect_same(robot);
  expect_same_from_memories(robot);
}

TEST(RerunOfOrders, DevicesThatAreLostAndFoundAreRepeated) {
  LiveRobot robot;
  robot.load(branching_text());
  robot.tick(3);
  robot.answers = false;
  robot.tick(3);
  robot.answers = true;
  ++robot.board.epoch;
  robot.board.left_travel_m = 0.25;
  robot.clock.advance(std::chrono::milliseconds(300));  // an overrun
  robot.tick(3);
  expect_same(robot);
  expect_same_from_memories(robot);
}

TEST(RerunOfOrders, AHoldAfterAFaultAndTheBumperThatEndsItAreRepeated) {
  LiveRobot robot(true);
  robot.load(branching_text());
  robot.tick(3);
  robot.answers = false;
  robot.tick(30);
  robot.answers = true;
  robot.tick(5);
  EXPECT_TRUE(robot.executive.held_after_fault());
  EXPECT_TRUE(robot.recorder.ticks.back().outcome.stops);
  robot.board.bumpers = 1U << 5U;
  robot.tick(2);
  robot.board.bumpers = 0;
  robot.tick(3);
  EXPECT_FALSE(robot.executive.held());
  expect_same(robot);
  expect_same_from_memories(robot);
}

TEST(RerunOfOrders, AnOrderThatIsNotRepeatedIsFound) {
  LiveRobot robot;
  robot.load(branching_text());
  robot.tick(3);
  robot.executive.hold();
  robot.tick(3);
  auto& ticks = robot.recorder.ticks;
  ASSERT_TRUE(ticks[3].hold_changed);
  ticks[3].hold_changed = false;
  ticks[3].orders_digest = orders_digest(ticks[3]);
  const auto result = robot.again();
  ASSERT_TRUE(result.divergence);
  EXPECT_EQ(result.divergence->tick, 4U);
  EXPECT_THAT(result.divergence->details, testing::Contains(HasSubstr("motors: recorded to stop")));
}

TEST(RerunOfOrders, AProgramWhoseTextIsNotRecordedIsTold) {
  LiveRobot robot;
  robot.load(branching_text());
  robot.tick(3);
  robot.recorder.ticks[0].program[0].files.clear();
  robot.recorder.ticks[0].orders_digest = orders_digest(robot.recorder.ticks[0]);
  EXPECT_THAT(robot.again().cannot_tell, HasSubstr("its text is not recorded"));
}

}  // namespace
}  // namespace galilean::robot
