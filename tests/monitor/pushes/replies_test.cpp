// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/pushes/history/replies.h"

#include <gtest/gtest.h>

namespace galilean::monitor {
namespace {

using namespace std::chrono_literals;
namespace status = msg::ProgramReply_Constants;

msg::ProgramReply reply(const std::string& robot, std::uint8_t said) {
  msg::ProgramReply result;
  result.id = "1";
  result.robot = robot;
  result.status = said;
  return result;
}

Replies asked(std::vector<std::string> robots) {
  return {"1", std::move(robots), Time{}};
}

TEST(Replies, IsCompleteWhenEachRunsOrRefuses) {
  auto replies = asked({"io", "ganymede"});
  EXPECT_TRUE(replies.note(reply("io", status::RECEIVED), Time{5ms}));
  EXPECT_TRUE(replies.note(reply("io", status::RUNNING), Time{20ms}));
  EXPECT_FALSE(replies.complete());
  EXPECT_TRUE(replies.note(reply("ganymede", status::REJECTED), Time{30ms}));
  EXPECT_TRUE(replies.complete());
  EXPECT_FALSE(replies.settled()) << "io is in its probation";
  replies.note(reply("io", status::CONFIRMED), Time{9s});
  EXPECT_TRUE(replies.settled());
  EXPECT_EQ(replies.all()[1].status, ReplyStatus::kConfirmed);
  EXPECT_EQ(replies.all()[1].latency_ms, 20) << "of the swap, not of what followed";
}

TEST(Replies, HearsNeitherOthersRepliesNorRepeats) {
  auto replies = asked({"io"});
  auto other = reply("io", status::RUNNING);
  other.id = "2";
  EXPECT_FALSE(replies.note(other, Time{}));
  EXPECT_TRUE(replies.note(reply("io", status::RUNNING), Time{}));
  EXPECT_FALSE(replies.note(reply("io", status::RECEIVED), Time{}));
  EXPECT_EQ(replies.all()[0].status, ReplyStatus::kRunning);
}

TEST(Replies, ANumberThatIsNotKnownDecidesAndIsNoSuccess) {
  auto replies = asked({"io"});
  EXPECT_TRUE(replies.note(reply("io", 9), Time{}));
  EXPECT_EQ(replies.all()[0].status, ReplyStatus::kUnknown);
  EXPECT_TRUE(replies.complete());
  EXPECT_FALSE(replies.taken_by_all());
}

TEST(Replies, EachSaysWhyItsRobotDoesNotRunTheProgram) {
  RobotReply io{.robot = "io"};
  EXPECT_EQ(failure_reason(io), "io has not answered");
  io.status = ReplyStatus::kRejected;
  EXPECT_EQ(failure_reason(io), "io refused it");
  io.status = ReplyStatus::kRolledBack;
  io.reply.message = "it overran its ticks";
  EXPECT_EQ(failure_reason(io), "io went back: it overran its ticks");
}

}  // namespace
}  // namespace galilean::monitor
