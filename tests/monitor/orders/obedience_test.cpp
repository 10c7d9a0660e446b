// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/orders/obedience.h"

#include <gtest/gtest.h>

namespace galilean::monitor {
namespace {

using Word = Operator::Word;

TEST(Obedience, ARobotThatIsResumedSaysWhatHadStoppedIt) {
  Before before;
  msg::RobotState now;
  EXPECT_EQ(outcome_of(Word::kResume, before, now), "goes on");
  before.stopped_by = "break point on entering grab (Anna)";
  EXPECT_EQ(outcome_of(Word::kResume, before, now),
            "goes on; it was stopped by break point on entering grab (Anna)");
  now.held = true;
  EXPECT_FALSE(complied(Word::kResume, before, now));
  EXPECT_EQ(outcome_of(Word::kResume, before, now), "did not answer; try again");
  EXPECT_EQ(outcome_of(Word::kHold, before, now), "stands still");
}

TEST(Obedience, AStartIsObeyedByAProgramThatLeavesItsState) {
  Before before;
  before.state.state = "start";
  msg::RobotState now = before.state;
  EXPECT_EQ(outcome_of(Word::kStart, before, now), "its bumper was pushed, but it stays in start");
  now.state = "wander";
  now.transitions = 1;
  EXPECT_EQ(outcome_of(Word::kStart, before, now), "start → wander");
}

TEST(Obedience, ServiceEndsAndBeginsAsTheRobotSays) {
  const Before before;
  msg::RobotState now;
  EXPECT_EQ(outcome_of(Word::kCommission, before, now), "is in service again");
  EXPECT_FALSE(complied(Word::kDecommission, before, now));
  now.out_of_service = true;
  EXPECT_EQ(outcome_of(Word::kDecommission, before, now), "is out of service");
}

}  // namespace
}  // namespace galilean::monitor
