// SPDX-License-Identifier: BSD-3-Clause
// Taking turns with other operators, by keys.
#include <gmock/gmock.h>

#include "tests/monitor/top/steered.h"

namespace galilean::monitor::top {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

class TakingTurns : public Steered {
 protected:
  static constexpr const char* kShown = "callisto";

  void hold(bool is_yours, const std::string& asker = {}) {
    pusher.leases[kShown] = {
        .holder = is_yours ? "ben" : "ada", .asker = asker, .is_yours = is_yours};
  }
};

TEST_F(TakingTurns, OneOperatorAloneNoticesNothing) {
  hold(true);
  EXPECT_THAT(screen(), Not(HasSubstr("steers")));
  press("s");
  EXPECT_THAT(said, ElementsAre("start callisto"));
}

TEST_F(TakingTurns, WhatAnotherHoldsIsShownAndNotSteeredButStopped) {
  hold(false);
  EXPECT_THAT(screen(), HasSubstr("ada"));
  press("s");
  press("n");
  press("r");
  press("R");
  EXPECT_THAT(said, IsEmpty());
  EXPECT_THAT(screen(), HasSubstr("ada steers callisto: m asks for it, M takes it over"));
  press("h");
  EXPECT_THAT(said, ElementsAre("hold callisto"));
}

TEST_F(TakingTurns, OfBreakPointsAnotherOperatorIsGivenNewOnesAloneAndNoLock) {
  namespace kinds = msg::BreakPoint_Constants;
  msg::Program program;
  program.robot = kShown;
  program.states = {{.name = "start"}, {.name = "grab"}};
  tell_of_program(program);
  msg::Breaks breaks;
  breaks.robot = kShown;
  tell_of_breaks(breaks);
  hold(false);
  press("Jb");
  EXPECT_EQ(said.size(), 1U) << "a break point stops";
  breaks.points = {{"start", "grab", kinds::STOP}, {"", "grab", kinds::STOP_TEAM}};
  tell_of_breaks(breaks);
  press("BxlC");
  press(Key::kDown);
  press("t");  // a lock
  EXPECT_EQ(said.size(), 1U);
  EXPECT_THAT(screen(), HasSubstr("ada steers callisto: m asks for it, M takes it over"));
}

TEST_F(TakingTurns, ItIsAskedForOnce) {
  hold(false);
  press("m");
  EXPECT_THAT(pusher.changed, ElementsAre("ask callisto"));
  pusher.leases[kShown].is_asked_by_you = true;
  press("m");
  EXPECT_EQ(pusher.changed.size(), 1U);
}

TEST_F(TakingTurns, ItIsTakenOverWithAReasonThatIsTyped) {
  hold(false);
  press("M");
  press(Key::kEnter);
  EXPECT_THAT(pusher.changed, IsEmpty());
  press("M");
  press("it stands");
  EXPECT_THAT(screen(), HasSubstr("Why take callisto over? it stands_"));
  press(Key::kEnter);
  EXPECT_THAT(pusher.changed, ElementsAre("take callisto: it stands"));
}

TEST_F(TakingTurns, WhoAsksIsNamedAndGivenItOrRefused) {
  hold(true, "carol");
  EXPECT_THAT(screen(), HasSubstr("carol asks for callisto"));
  press("m");
  press("M");
  EXPECT_THAT(pusher.changed, ElementsAre("give callisto", "refuse callisto"));
}

TEST_F(TakingTurns, WhatTheMonitorRefusesIsTold) {
  pusher.lease_refusal = "carol has asked ada for callisto already";
  dashboard.update();
  EXPECT_THAT(screen(), HasSubstr("carol has asked ada for callisto already"));
}

TEST_F(TakingTurns, WithoutAMonitorTheKeysSayThatNobodyElseSteers) {
  press("m");
  press("M");
  EXPECT_THAT(pusher.changed, IsEmpty());
  EXPECT_THAT(screen(), HasSubstr("No other operator steers callisto."));
}

}  // namespace
}  // namespace galilean::monitor::top
