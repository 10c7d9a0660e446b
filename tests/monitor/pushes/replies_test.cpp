// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/pushes/history/replies.h"

#include <gtest/gtest.h>

#include <algorithm>

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

TEST(Replies, KeepsThoseOfAllThatWereAskedAndTheNewestOfOthers) {
  auto replies = asked({"io", "ganymede"});
  EXPECT_TRUE(replies.note(reply("io", status::RUNNING), Time{}));
  constexpr std::size_t kStrangers = Replies::kMostUnasked + 7;
  for (std::size_t i = 0; i < kStrangers; ++i)
    EXPECT_TRUE(replies.note(reply("stranger_" + std::to_string(i), status::RUNNING), Time{}));
  const auto all = replies.all();
  EXPECT_EQ(all.size(), 2 + Replies::kMostUnasked);
  EXPECT_EQ(replies.dropped(), 7U);
  const auto has = [&](const std::string& robot) {
    return std::ranges::find(all, robot, &RobotReply::robot) != all.end();
  };
  EXPECT_FALSE(has("stranger_6"));
  EXPECT_TRUE(has("stranger_7"));
  EXPECT_TRUE(has("stranger_" + std::to_string(kStrangers - 1)));
  EXPECT_TRUE(has("ganymede")) << "it was asked, and has not answered";
  EXPECT_FALSE(replies.complete());
  EXPECT_TRUE(replies.note(reply("ganymede", status::RUNNING), Time{}));
  EXPECT_TRUE(replies.complete());
  EXPECT_EQ(replies.dropped(), 7U);
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
