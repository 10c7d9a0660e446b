// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/top/model/break_marks.h"

#include <gtest/gtest.h>

namespace galilean::monitor::top {
namespace {

namespace points = msg::BreakPoint_Constants;

msg::Breaks breaks_at(std::vector<msg::BreakPoint> points) {
  msg::Breaks breaks;
  breaks.points = std::move(points);
  return breaks;
}

TEST(BreakMarks, APointThatNamesOneStateMarksItOrEachWayOutOfIt) {
  const auto breaks = breaks_at({{"", "grab", points::STOP}, {"wander", "", points::STOP_TEAM}});
  EXPECT_EQ(mark_on_entering(breaks, "grab"), BreakMark::kStop);
  EXPECT_EQ(mark_on_entering(breaks, "wander"), BreakMark::kNone);
  EXPECT_EQ(mark_at(breaks, "wander", "grab"), BreakMark::kStopTeam);
  EXPECT_EQ(mark_at(breaks, "wander", "rest"), BreakMark::kStopTeam);
  EXPECT_EQ(mark_at(breaks, "rest", "grab"), BreakMark::kNone);
}

TEST(BreakMarks, APointThatNamesBothStatesMarksThatTransitionAlone) {
  const auto breaks = breaks_at({{"wander", "grab", points::LOCK}});
  EXPECT_EQ(mark_at(breaks, "wander", "grab"), BreakMark::kLock);
  EXPECT_EQ(mark_at(breaks, "wander", "rest"), BreakMark::kNone);
  EXPECT_EQ(mark_on_entering(breaks, "grab"), BreakMark::kNone);
}

TEST(BreakMarks, OfSeveralALockCountsMostAndAnUnknownKindNothing) {
  const auto breaks =
      breaks_at({{"wander", "grab", points::LOCK}, {"wander", "", points::STOP}, {"", "rest", 9}});
  EXPECT_EQ(mark_at(breaks, "wander", "grab"), BreakMark::kLock);
  EXPECT_EQ(mark_at(breaks, "wander", "rest"), BreakMark::kStop);
  EXPECT_EQ(mark_on_entering(breaks, "rest"), BreakMark::kNone);
  EXPECT_EQ(mark_on_entering({}, "rest"), BreakMark::kNone);
}

}  // namespace
}  // namespace galilean::monitor::top
