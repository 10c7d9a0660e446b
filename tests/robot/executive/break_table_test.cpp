// SPDX-License-Identifier: BSD-3-Clause
// The table of break points: what is accepted, and how it reaches the control loop.
#include <gmock/gmock.h>

#include "tests/robot/executive/branching_robot.h"

namespace galilean::robot {
namespace {

using testing::HasSubstr;

std::vector<BreakPoint> points_named(int from, int to) {
  std::vector<BreakPoint> points;
  for (int i = from; i < to; ++i)
    points.push_back({{"", "state_" + std::to_string(i)}, BreakKind::kStop, "Anna"});
  return points;
}

TEST(BreakTable, HasRoomForThirtyTwoAndRefusesAnOrderForMoreWhole) {
  Breaks breaks;
  ASSERT_TRUE(breaks.set(points_named(0, 31)));
  const auto refused = breaks.set(points_named(31, 33));
  ASSERT_FALSE(refused);
  EXPECT_THAT(refused.error().message, HasSubstr("33 break points, and 32 are the most"));
  EXPECT_EQ(breaks.points().size(), 31U);
  EXPECT_TRUE(breaks.set(points_named(31, 32)));
  EXPECT_TRUE(breaks.set(points_named(0, 32))) << "what is set in place of another takes no room";
  EXPECT_FALSE(breaks.set(points_named(32, 33)));
  EXPECT_EQ(breaks.points().size(), 32U);
}

TEST(BreakTable, APointReplacesThatOfTheSameTwoStates) {
  Breaks breaks;
  ASSERT_TRUE(breaks.set({{{"a", "b"}, BreakKind::kStop, "Anna"}}));
  ASSERT_TRUE(breaks.set({{{"a", "b"}, BreakKind::kLock, "Ben"}, {{"a", ""}}}));
  ASSERT_EQ(breaks.points().size(), 2U);
  EXPECT_EQ(breaks.points()[0].kind, BreakKind::kLock);
  EXPECT_EQ(breaks.points()[0].author, "Ben");
}

TEST(BreakTable, OneOfTwoPointsThatNamesNoStateRefusesBoth) {
  Breaks breaks;
  EXPECT_THAT(breaks.set({{{"a", "b"}}, {{"", ""}}}).error().message,
              HasSubstr("must name the state"));
  EXPECT_TRUE(breaks.points().empty());
}

TEST(BreakTable, WhatIsRemovedMustBeThere) {
  Breaks breaks;
  ASSERT_TRUE(breaks.set({{{"a", "b"}}, {{"", "b"}}, {{"a", ""}}}));
  EXPECT_EQ(breaks.remove({{"b", "a"}}).error().message, "there is no break point b -> a");
  EXPECT_EQ(breaks.remove({{"b", ""}, {"", "a"}}).error().message,
            "there is none of these break points");
  EXPECT_TRUE(breaks.remove({{"a", ""}, {"b", ""}})) << "one of them is there";
  EXPECT_TRUE(breaks.remove({{"", "b"}}));
  ASSERT_EQ(breaks.points().size(), 1U);
  EXPECT_EQ(breaks.points()[0].at, (StateChange{"a", "b"}));
  breaks.clear();
  EXPECT_TRUE(breaks.points().empty());
}

TEST(BreakTable, KnowsThePointThatStoppedTheRobotAlsoWhenItIsGone) {
  Breaks breaks;
  ASSERT_TRUE(breaks.set({{{"a", "b"}, BreakKind::kStop, "Anna"}}));
  const auto number = breaks.points()[0].number;
  ASSERT_TRUE(breaks.set({{{"a", "b"}, BreakKind::kStop, "Ben"}}));
  EXPECT_EQ(breaks.find(number)->author, "Anna");
  const auto second = breaks.points()[0].number;
  breaks.clear();
  EXPECT_EQ(breaks.find(second)->author, "Ben");
  EXPECT_FALSE(breaks.find(99));
}

TEST(BreakTable, SaysWhereAPointIs) {
  EXPECT_EQ(in_words(StateChange{"a", "b"}), "a -> b");
  EXPECT_EQ(in_words(StateChange{"", "b"}), "on entering b");
  EXPECT_EQ(in_words(StateChange{"a", ""}), "on leaving a");
}

}  // namespace
}  // namespace galilean::robot
