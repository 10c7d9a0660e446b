// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/orders/obedience.h"

#include <gtest/gtest.h>

namespace galilean::monitor {
namespace {

using Word = Operator::Word;

TEST(Obedience, ARobotThatIsResumedSaysWhatHadStoppedIt) {
  RobotReport before, now;
  EXPECT_EQ(outcome_of(Word::kResume, before, now), "goes on");
  before.stopped_by = "break point on entering grab (Anna)";
  EXPECT_EQ(outcome_of(Word::kResume, before, now),
            "goes on; it was stopped by break point on entering grab (Anna)");
  now.state.held = true;
  EXPECT_FALSE(complied(Word::kResume, before, now));
  EXPECT_EQ(outcome_of(Word::kResume, before, now), "did not answer; try again");
  EXPECT_EQ(outcome_of(Word::kHold, before, now), "stands still");
}

TEST(Obedience, AHoldIsObeyedWhenItHasTakenTheBreakPointsPlace) {
  RobotReport now;
  now.state.held = true;
  now.stopped_by = "a step (Anna)";
  EXPECT_EQ(outcome_of(Word::kHold, now, now), "did not answer; try again");
  const RobotReport before = now;
  now.stopped_by.clear();
  EXPECT_EQ(outcome_of(Word::kHold, before, now), "stands still");
}

TEST(Obedience, AStartIsObeyedByAProgramThatLeavesItsState) {
  RobotReport before;
  before.state.state = "start";
  RobotReport now = before;
  EXPECT_EQ(outcome_of(Word::kStart, before, now), "its bumper was pushed, but it stays in start");
  now.state.state = "wander";
  now.state.transitions = 1;
  EXPECT_EQ(outcome_of(Word::kStart, before, now), "start → wander");
}

TEST(Obedience, ServiceEndsAndBeginsAsTheRobotSays) {
  const RobotReport before;
  RobotReport now;
  EXPECT_EQ(outcome_of(Word::kCommission, before, now), "is in service again");
  EXPECT_FALSE(complied(Word::kDecommission, before, now));
  now.state.out_of_service = true;
  EXPECT_EQ(outcome_of(Word::kDecommission, before, now), "is out of service");
}

}  // namespace
}  // namespace galilean::monitor
