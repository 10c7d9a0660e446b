// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/orders/break_words.h"

#include <gmock/gmock.h>

#include "core/wire/ros_time.h"

namespace galilean::monitor {
namespace {

using testing::ElementsAre;
namespace points = msg::BreakPoint_Constants;

msg::BreakPoint point(const std::string& from, const std::string& to, std::uint8_t kind) {
  return {from, to, kind};
}

TEST(BreakWords, APlaceIsAStateThatIsEnteredOrAChangeOfState) {
  EXPECT_EQ(place_in("grab"), point("", "grab", 0));
  EXPECT_EQ(place_in(":grab"), point("", "grab", 0));
  EXPECT_EQ(place_in("wander:grab"), point("wander", "grab", 0));
  EXPECT_EQ(place_in("wander:"), point("wander", "", 0));
  EXPECT_EQ(place_in(":"), point("", "", 0));
}

TEST(BreakWords, ARuleSaysWhatHappensWhere) {
  EXPECT_EQ(rule_of(point("", "grab", points::STOP)), "stops on entering grab");
  EXPECT_EQ(rule_of(point("wander", "", points::STOP_TEAM)), "stops the team on leaving wander");
  EXPECT_EQ(rule_of(point("wander", "grab", points::LOCK)), "is locked at wander -> grab");
  EXPECT_EQ(rule_of(point("", "grab", 9)),
            "has a break point of the unknown kind 9 on entering grab");
}

TEST(BreakWords, WhatARobotTellsIsASentenceALine) {
  msg::Breaks told;
  EXPECT_THAT(lines_of(told), ElementsAre("has no break points"));
  told.points = {point("", "grab", points::STOP), point("wander", "rest", points::LOCK)};
  told.stopped = true;
  told.stopped_by = msg::Breaks_Constants::BREAK_POINT;
  told.break_point = told.points[0];
  told.author = "Anna";
  EXPECT_THAT(lines_of(told), ElementsAre("stops on entering grab", "is locked at wander -> rest",
                                          "was stopped by break point on entering grab (Anna)"));
  told = {};
  told.stepping = true;
  told.waits_at_from = "wander";
  told.waits_at_to = "rest";
  told.waits_since = wire::ros_time(5'000'000'000);
  told.stamp = wire::ros_time(8'900'000'000);
  EXPECT_THAT(lines_of(told),
              ElementsAre("has no break points", "goes on until its next change of state",
                          "has waited at the lock wander -> rest for 3 s"));
}

TEST(BreakWords, ARobotThatNobodyStoppedHasNoReason) {
  msg::Breaks told;
  told.stopped_by = msg::Breaks_Constants::STEP;
  EXPECT_EQ(reason_of(told), "");
  told.stopped = true;
  EXPECT_EQ(reason_of(told), "a step");
}

TEST(BreakWords, AnEffectSaysWhatAnOrderDid) {
  msg::BreakOrder order;
  order.order = "set";
  order.points = {point("", "grab", points::STOP), point("wander", "rest", points::LOCK)};
  EXPECT_EQ(effect_of(order), "stops on entering grab, is locked at wander -> rest");
  order.order = "remove";
  EXPECT_EQ(effect_of(order), "no longer stops or waits on entering grab, at wander -> rest");
  order.order = "let_through";
  EXPECT_EQ(effect_of(order), "opens the lock once on entering grab, at wander -> rest");
  order.order = "clear";
  EXPECT_EQ(effect_of(order), "has no break points");
}

TEST(BreakWords, FindsStatesThatAProgramDoesNotHave) {
  msg::Program program;
  program.states = {{.name = "wander"}, {.name = "grab"}};
  msg::BreakOrder order;
  order.points = {point("", "grab", points::STOP), point("wander", "gras", points::STOP)};
  EXPECT_THAT(unknown_states(order, program), ElementsAre("gras"));
}

}  // namespace
}  // namespace galilean::monitor
