// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/top/sheets/answer_words.h"

#include <gtest/gtest.h>

namespace galilean::monitor::top {
namespace {

namespace statuses = msg::ProgramReply_Constants;
using Stage = PushReport::Stage;

class AnswerWords : public testing::Test {
 protected:
  void reply(const std::string& robot, std::uint8_t status, const std::string& message = "",
             const std::string& id = "7") {
    msg::ProgramReply reply;
    reply.id = id;
    reply.robot = robot;
    reply.status = status;
    reply.message = message;
    replies.push_back(reply);
  }
  std::string words() { return answer_words(report, replies); }

  PushReport report{Stage::kPushing, "Push of office.bhdl: running", {{"check  done"}}, "7"};
  std::deque<msg::ProgramReply> replies;
};

TEST_F(AnswerWords, TellHowFarTheSlowestRobotIs) {
  reply("io", statuses::CONFIRMED, "", "6");
  EXPECT_EQ(words(), "sent");
  reply("io", statuses::RECEIVED);
  EXPECT_EQ(words(), "is being built");
  reply("io", statuses::RUNNING);
  reply("callisto", statuses::RECEIVED);
  EXPECT_EQ(words(), "is being built");
  reply("callisto", statuses::RUNNING);
  report.stage = Stage::kDone;
  EXPECT_EQ(words(), "runs, on probation");
  reply("io", statuses::CONFIRMED);
  reply("callisto", statuses::CONFIRMED);
  EXPECT_EQ(words(), "taken");
}

TEST_F(AnswerWords, TellWhoRefusedAndWhoWentBackAndWhy) {
  reply("io", statuses::REJECTED, "no camera");
  reply("callisto", statuses::ROLLED_BACK);
  EXPECT_EQ(words(), "callisto went back; io refused it: no camera");
}

TEST_F(AnswerWords, TellWhatTheMonitorObjectsTo) {
  report = {Stage::kRefused, "Nothing was pushed", {{"Anna pushed spin.bhdl"}}};
  EXPECT_EQ(words(), "Nothing was pushed: Anna pushed spin.bhdl");
}

}  // namespace
}  // namespace galilean::monitor::top
