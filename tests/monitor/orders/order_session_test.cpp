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
  EXPECT_EQ(session.value()->find({.robots = {"io", "ganymede"}}).value(), 2U);
  EXPECT_EQ(session.value()->find({.robots = {}, .team = true}).value(), 2U);
  EXPECT_THAT(session.value()->everyone({.robots = {}, .team = true}),
              ElementsAre("ganymede", "io"));
  EXPECT_EQ(session.value()->state_of("io")->state, "start");
  EXPECT_THAT(session.value()->find({.robots = {"europa"}}).error().message,
              HasSubstr("europa sends no state"));
  EXPECT_EQ(session.value()->find({.robots = {"europa", "io"}}, Duration{}).value(), 1U);
}

TEST(OrderSession, KnowsRobotsThatSendNothingByTheirWritersAndByAMonitor) {
  const ScriptedRobot io("io", kDomain, "{}");
  const auto others = wire::Participant::join("others", kDomain);
  const wire::Writer<msg::RobotState> hanging(*others.value(),
                                              wire::robot_topic("callisto", "state"));
  wire::Writer<msg::ObjectMap> monitor(*others.value(), wire::kObjectsTopic);
  msg::ObjectMap map;
  map.robots.resize(1);
  map.robots[0].name = "ganymede";
  map.robots[0].age_s = 0.3F;
  ASSERT_TRUE(monitor.write(map));
  const auto session = OrderSession::join("test", kDomain);
  ASSERT_TRUE(session);
  ASSERT_TRUE(session.value()->find({.robots = {"io"}}));
  const auto known = session.value()->everyone({.robots = {}, .team = true});
  EXPECT_THAT(known, ElementsAre("callisto", "ganymede", "io"));
  EXPECT_FALSE(session.value()->is_there("ganymede"));
  EXPECT_EQ(session.value()->silence_of("ganymede"),
            "has sent nothing for 1 s, so it is not known what it does");
  EXPECT_EQ(session.value()->silence_of("callisto"), "sends no state");
}

TEST(OrderSession, ARobotThatARecordingPlaysIsNotThere) {
  const auto replay = wire::Participant::join(wire::kReplayName, kDomain);
  wire::Writer<msg::RobotState> states(*replay.value(), wire::robot_topic("io", "state"));
  msg::RobotState state;
  state.robot = "io";
  ASSERT_TRUE(states.write(state));
  const auto session = OrderSession::join("test", kDomain);
  ASSERT_TRUE(session);
  EXPECT_THAT(session.value()->find({.robots = {"io"}}).error().message,
              HasSubstr("io is played by a recording, and is not there"));
  EXPECT_THAT(session.value()->everyone({.robots = {}, .team = true}), IsEmpty());
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
