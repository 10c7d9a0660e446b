// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/orders/order_session.h"

#include <gmock/gmock.h>

#include "core/wire/topic_names.h"
#include "tests/free_domain.h"
#include "tests/monitor/scripted_robot.h"

namespace galilean::monitor {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

const int kDomain = free_domain();

TEST(OrderSession, FindsTheRobotsThatTellHowTheyAre) {
  const ScriptedRobot io("io", kDomain, "{}"), ganymede("ganymede", kDomain, "{}");
  const auto session = OrderSession::join("test", kDomain);
  ASSERT_TRUE(session);
  // Both are named, so that it waits for both.
  EXPECT_THAT(session.value()->find({.robots = {"io", "ganymede"}}).value(),
              ElementsAre("io", "ganymede"));
  EXPECT_THAT(session.value()->find({.robots = {}, .team = true}).value(),
              ElementsAre("ganymede", "io"));
  EXPECT_EQ(session.value()->state_of("io")->state, "start");
  EXPECT_THAT(session.value()->find({.robots = {"europa"}}).error().message,
              HasSubstr("europa sends no state"));
}

TEST(OrderSession, KnowsWhoAnsweredAnOrder) {
  const ScriptedRobot io("io", kDomain, "{}");
  const auto participant = wire::Participant::join("scripted-breaks", kDomain);
  wire::Writer<msg::Breaks> breaks(*participant.value(), wire::robot_topic("io", "breaks"));
  msg::Breaks told;
  told.robot = "io";
  told.answers = {{"order 1", "it stands"}, {"another operator's", ""}};
  ASSERT_TRUE(breaks.write(told));
  const auto session = OrderSession::join("test", kDomain);
  ASSERT_TRUE(session);
  EXPECT_THAT(session.value()->wait_for_answers({"io"}, "order 1"), IsEmpty());
  EXPECT_THAT(session.value()->wait_for_answers({"io", "ganymede"}, "order 2"),
              ElementsAre("io", "ganymede"));
  EXPECT_EQ(session.value()->answer_of("io", "order 1")->refused, "it stands");
  EXPECT_EQ(session.value()->answer_of("io", "order 2"), nullptr);
  EXPECT_EQ(session.value()->answer_of("ganymede", "order 1"), nullptr);
  EXPECT_EQ(session.value()->breaks_of("ganymede"), nullptr);
}

}  // namespace
}  // namespace galilean::monitor
