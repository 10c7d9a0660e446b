// SPDX-License-Identifier: BSD-3-Clause
// Transitions that do not fire without an operator.
#include <gmock/gmock.h>

#include "tests/robot/executive/branching_robot.h"

namespace galilean::robot {
namespace {

using testing::HasSubstr;

class LocksTest : public testing::Test {
 protected:
  LocksTest() { robot.set("wander", "grab", BreakKind::kLock); }

  [[nodiscard]] Result<void> let_through(const std::string& from, const std::string& to) {
    return robot.executive->breaks().let_through({{from, to}}, robot.executive->present_state());
  }
  [[nodiscard]] const LockWait& wait() const { return robot.events.standstill.wait; }

  BranchingRobot robot;
};

TEST_F(LocksTest, ALockedTransitionDoesNotFireAndTheRobotWaitsAndDrivesOn) {
  robot.press(0);
  robot.tick();
  const Time began = robot.now();
  robot.tick(5);
  EXPECT_EQ(robot.state(), "wander");
  EXPECT_TRUE(robot.drive.moving);
  EXPECT_EQ(wait().condition, 0U);
  EXPECT_EQ(wait().since, began);
  robot.press(0, false);
  robot.tick();
  EXPECT_EQ(wait(), LockWait{});
}

TEST_F(LocksTest, ALaterConditionFiresInItsPlace) {
  robot.press(0);
  robot.press(1);
  robot.tick();
  EXPECT_EQ(robot.state(), "rest");
  EXPECT_EQ(wait(), LockWait{});
  const Event& change = *robot.events.last(Event::Kind::kTransition);
  EXPECT_EQ(change.condition, 1U);
  EXPECT_EQ(change.tested.holds, 0b11U) << "the locked one held";
}

TEST_F(LocksTest, IsLetThroughExactlyOnce) {
  robot.press(0);
  robot.tick();
  ASSERT_TRUE(let_through("wander", "grab"));
  ASSERT_TRUE(let_through("wander", "grab")) << "by a second operator";
  robot.tick();
  EXPECT_EQ(robot.state(), "grab");
  robot.press(0, false);
  robot.go_to("wander");
  robot.press(0);
  robot.tick(3);
  EXPECT_EQ(robot.state(), "wander") << "the lock is there again";
  EXPECT_EQ(wait().condition, 0U);
}

TEST_F(LocksTest, APermissionEndsWithTheState) {
  ASSERT_TRUE(let_through("wander", "grab"));
  robot.go_to("rest");
  robot.go_to("wander");
  robot.go_to("grab");
  EXPECT_EQ(robot.state(), "wander");
}

TEST_F(LocksTest, ALockThatIsSetAnewIsShut) {
  ASSERT_TRUE(let_through("wander", "grab"));
  robot.set("wander", "grab", BreakKind::kLock);
  robot.go_to("grab");
  EXPECT_EQ(robot.state(), "wander");
}

TEST_F(LocksTest, WhatIsNotLockedOrBeginsInAnotherStateCannotBeLetThrough) {
  EXPECT_EQ(let_through("wander", "rest").error().message, "there is no lock wander -> rest");
  robot.stop_at("wander", "rest");
  EXPECT_FALSE(let_through("wander", "rest")) << "a break point is no lock";
  robot.go_to("rest");
  EXPECT_THAT(let_through("wander", "grab").error().message,
              HasSubstr("in rest, and not in wander"));
  robot.go_to("wander");
  robot.go_to("grab");
  EXPECT_EQ(robot.state(), "wander");
}

TEST_F(LocksTest, OfAnyStateIsLetThroughByTheNameOfTheTransition) {
  ASSERT_TRUE(robot.executive->breaks().remove({{"wander", "grab"}}));
  robot.set("", "grab", BreakKind::kLock);
  robot.go_to("grab");
  ASSERT_EQ(robot.state(), "wander");
  ASSERT_TRUE(let_through("wander", "grab"));
  robot.go_to("grab");
  EXPECT_EQ(robot.state(), "grab");
}

TEST_F(LocksTest, TakenOffItNoLongerKeepsTheTransitionFromFiring) {
  robot.press(0);
  robot.tick();
  ASSERT_TRUE(robot.executive->breaks().remove({{"wander", "grab"}}));
  robot.tick();
  EXPECT_EQ(robot.state(), "grab");
}

TEST_F(LocksTest, WhatIsLetThroughStopsAtABreakPoint) {
  robot.stop_at("", "grab");
  ASSERT_TRUE(let_through("wander", "grab"));
  robot.go_to("grab");
  EXPECT_EQ(robot.state(), "grab");
  EXPECT_EQ(robot.events.standstill.hold, Hold::kBreakPoint);
}

TEST_F(LocksTest, OutlivesASwap) {
  ASSERT_TRUE(robot.load(branching_text() + "; another text"));
  robot.tick();
  ASSERT_EQ(robot.events.count(Event::Kind::kSwapped), 1);
  robot.go_to("grab");
  EXPECT_EQ(robot.state(), "wander");
}

}  // namespace
}  // namespace galilean::robot
