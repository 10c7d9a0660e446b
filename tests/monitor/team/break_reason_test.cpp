// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/team/break_reason.h"

#include <gtest/gtest.h>

#include "core/wire/ros_time.h"
#include "monitor/team/team.h"

namespace galilean::monitor {
namespace {

using namespace std::chrono_literals;
namespace points = msg::BreakPoint_Constants;
namespace stoppers = msg::Breaks_Constants;

class BreakReasonTest : public testing::Test {
 protected:
  BreakReasonTest() {
    clock.advance(1h);
    breaks.robot = "io";
  }

  std::string reason() {
    team.note(breaks);
    return present_reason();
  }
  [[nodiscard]] std::string present_reason() const {
    return team.status(*team.find("io")).break_reason;
  }
  void stopped(std::uint64_t number, std::uint8_t by, const std::string& author,
               const msg::BreakPoint& point = {}) {
    breaks.stopped = true;
    breaks.stopped_at = number;
    breaks.stopped_by = by;
    breaks.break_point = point;
    breaks.author = author;
  }
  void changed(std::uint64_t number, const std::string& from, const std::string& to) {
    msg::Transition transition;
    transition.robot = "io";
    transition.number = number;
    transition.from_state = from;
    transition.to_state = to;
    team.note(transition);
  }

  SteppedClock clock;
  Team team{clock, 2s};
  msg::Breaks breaks;
};

TEST_F(BreakReasonTest, ARobotThatNothingKeepsHasNone) {
  msg::RobotState state;
  state.robot = "io";
  team.note(state);
  EXPECT_EQ(present_reason(), "") << "it has told nothing of break points";
  breaks.points = {{"wander", "grab", points::STOP}};
  EXPECT_EQ(reason(), "");
}

TEST_F(BreakReasonTest, ABreakPointSaysWhereAndWhose) {
  stopped(7, stoppers::BREAK_POINT, "Anna", {"wander", "grab", points::STOP});
  EXPECT_EQ(reason(), "stopped at wander -> grab (Anna's break point)");
  stopped(7, stoppers::BREAK_POINT, "Anna", {"", "grab", points::STOP});
  EXPECT_EQ(reason(), "stopped on entering grab (Anna's break point)");
  stopped(7, stoppers::BREAK_POINT, "");
  EXPECT_EQ(reason(), "stopped at a break point") << "it was taken off long ago";
}

TEST_F(BreakReasonTest, TheChangeOfStateThatStoppedItIsNamedWhereItIsKnown) {
  changed(7, "move_to_trash", "grab");
  changed(8, "grab", "wander");
  stopped(7, stoppers::BREAK_POINT, "Anna", {"", "grab", points::STOP});
  EXPECT_EQ(reason(), "stopped at move_to_trash -> grab (Anna's break point)");
}

TEST_F(BreakReasonTest, AStepSaysWhereItLed) {
  stopped(8, stoppers::STEP, "Anna");
  EXPECT_EQ(reason(), "stopped after a step");
  changed(8, "wander", "grab");
  EXPECT_EQ(reason(), "stepped into grab");
}

TEST_F(BreakReasonTest, AnotherRobotsBreakPointIsSaidToBeIts) {
  breaks.break_robot = "ganymede";
  stopped(0, stoppers::TEAM, "Anna", {"wander", "grab", points::STOP_TEAM});
  EXPECT_EQ(reason(), "stopped by ganymede's break point wander -> grab, set by Anna");
  stopped(0, stoppers::TEAM, "", {"wander", "grab", points::STOP_TEAM});
  EXPECT_EQ(reason(), "stopped by ganymede's break point wander -> grab");
}

TEST_F(BreakReasonTest, NamesLikeThoseOfTheSentencesDoNotMisleadIt) {
  stopped(7, stoppers::BREAK_POINT, "Anna", {"a step", "x -> y", points::STOP});
  EXPECT_EQ(reason(), "stopped at a step -> x -> y (Anna's break point)");
}

TEST_F(BreakReasonTest, AReasonOfALaterReleaseIsSaidToBeUnknown) {
  stopped(7, 99, "Anna");
  EXPECT_EQ(reason(), "stopped by a reason that this release does not know, set by Anna");
}

TEST_F(BreakReasonTest, AWaitAtALockGoesOnBetweenMessages) {
  breaks.waits_at_from = "grab";
  breaks.waits_at_to = "move";
  breaks.waits_since = wire::ros_time(100'000'000'000);
  breaks.stamp = wire::ros_time(102'500'000'000);
  EXPECT_EQ(reason(), "waits at the lock grab -> move for 2 s");
  clock.advance(700ms);
  EXPECT_EQ(present_reason(), "waits at the lock grab -> move for 3 s");
  EXPECT_NEAR(lock_wait_s(breaks, 700ms), 3.2, 1e-9);
  breaks.stamp = wire::ros_time(99'000'000'000);
  EXPECT_EQ(reason(), "waits at the lock grab -> move for 0 s") << "its clock was set back";
}

TEST_F(BreakReasonTest, OfASilentRobotNobodyKnowsWhetherItStillWaits) {
  breaks.waits_at_from = "grab";
  breaks.waits_at_to = "move";
  EXPECT_NE(reason(), "");
  clock.advance(3s);
  EXPECT_EQ(present_reason(), "");
}

TEST_F(BreakReasonTest, AStepThatIsUnderWayIsSaid) {
  breaks.stepping = true;
  EXPECT_EQ(reason(), "goes on until its next change of state");
}

TEST_F(BreakReasonTest, AFaultThatHoldsItIsSaid) {
  const std::string why = "held: the serial line was gone for 3.2 s; resume it, or push a bumper.";
  msg::RobotState state;
  state.robot = "io";
  state.held = true;
  state.problems = {"camera: gone", why};
  team.note(state);
  EXPECT_EQ(present_reason(), why);
  breaks.waits_at_from = "grab";
  EXPECT_EQ(reason(), why) << "more than a lock";
  state.held = false;
  team.note(state);
  EXPECT_NE(present_reason(), why) << "somebody has resumed it";
}

TEST_F(BreakReasonTest, TheNewestBreaksCount) {
  stopped(7, stoppers::BREAK_POINT, "Anna", {"wander", "grab", points::STOP});
  EXPECT_NE(reason(), "");
  breaks = {};
  breaks.robot = "io";
  EXPECT_EQ(reason(), "");
}

}  // namespace
}  // namespace galilean::monitor
