// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/top/model/stop_order.h"

#include <gtest/gtest.h>

#include "tests/monitor/top/model/told.h"

namespace galilean::monitor::top {
namespace {

using std::chrono::milliseconds;
using std::chrono::seconds;

TEST(StopSentence, NamesWhoWaitsAndCountsTheRest) {
  EXPECT_EQ(stop_sentence({}), "No robot is heard that could stop.");
  EXPECT_EQ(stop_sentence({{"io", "ganymede"}, {}}), "All 2 robots have stopped.");
  EXPECT_EQ(stop_sentence({{"io"}, {{"callisto", 14}}}),
            "1 of 2 stopped; callisto has not answered for 14 s");
  EXPECT_EQ(
      stop_sentence({{}, {{"a", 9}, {"b", 8, true}, {"c", 7}, {"d", 6}, {"e", 5}}}),
      "0 of 5 stopped; a has not answered for 9.0 s, b answers but has not stopped for 8.0 s, "
      "c has not answered for 7.0 s, and 2 more robots did not confirm");
}

TEST_F(Told, ARobotConfirmsByAStateThatCameAfterTheOrder) {
  tell_of({.held = true});
  clock.advance(seconds(1));
  const StopOrder order(clock.now());
  const auto progress = [&] { return order.progress(model.team(), clock.now()); };
  EXPECT_EQ(progress().unconfirmed.size(), 1u);  // what it said before does not count
  clock.advance(milliseconds(100));
  tell_of({.held = false});
  ASSERT_EQ(progress().unconfirmed.size(), 1u);
  EXPECT_TRUE(progress().unconfirmed[0].drives_on);
  clock.advance(milliseconds(100));
  tell_of({.held = true});
  EXPECT_EQ(progress().stopped, std::vector<std::string>{"io"});
}

TEST_F(Told, NobodyWaitsForARobotThatARecordingPlays) {
  replayed = true;
  tell_of({});
  const StopOrder order(clock.now());
  EXPECT_TRUE(order.progress(model.team(), clock.now()).unconfirmed.empty());
}

TEST_F(Told, AStopAtABreakPointIsNoneOfTheOrder) {
  const StopOrder order(clock.now());
  const auto progress = [&] { return order.progress(model.team(), clock.now()); };
  msg::Breaks breaks;
  breaks.robot = "io";
  breaks.stopped = true;
  tell_of_breaks(breaks);
  clock.advance(milliseconds(100));
  tell_of({.held = true});
  ASSERT_EQ(progress().unconfirmed.size(), 1u);
  EXPECT_FALSE(progress().unconfirmed[0].drives_on);
  breaks.stopped = false;
  tell_of_breaks(breaks);
  EXPECT_EQ(progress().stopped, std::vector<std::string>{"io"});
}

TEST_F(Told, ARobotThatConfirmedOnceIsDoneAndOneThatIsReleasedIsOutOfTheOrder) {
  StopOrder order(clock.now());
  clock.advance(milliseconds(100));
  tell_of({.robot = "io", .held = true});
  tell_of({.robot = "ganymede"});
  order.update(model.team());
  tell_of({.robot = "io", .held = false});  // somebody else resumed it
  EXPECT_EQ(order.progress(model.team(), clock.now()).stopped, std::vector<std::string>{"io"});
  order.release("ganymede");
  EXPECT_TRUE(order.progress(model.team(), clock.now()).unconfirmed.empty());
}

}  // namespace
}  // namespace galilean::monitor::top
