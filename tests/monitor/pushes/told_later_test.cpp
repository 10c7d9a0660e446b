// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/pushes/history/told_later.h"

#include <gmock/gmock.h>

#include "core/random.h"
#include "core/wire/ros_time.h"

namespace galilean::monitor {
namespace {

using testing::HasSubstr;
using enum ReplyStatus;

RobotReply reply_of(const std::string& robot, ReplyStatus status) {
  return {.robot = robot, .status = status};
}

/// A push whose last step is as `rest` says.
PushRecord ended(PushState state, StepState rest, std::vector<RobotReply> replies) {
  PushRecord push{.id = "1",
                  .pushed_ns = 1'000'000'000,
                  .author = "balch",
                  .program = {},
                  .hash = "new",
                  .targets = {}};
  push.progress.state = state;
  push.progress.steps = {{StepKind::kCheck, StepState::kDone},
                         {StepKind::kTry, StepState::kLeftOut},
                         {StepKind::kCanary, StepState::kLeftOut},
                         {StepKind::kRest, rest, rest == StepState::kFailed ? "io is away" : ""}};
  push.replies = std::move(replies);
  return push;
}

TEST(ToldLater, APushOfAMonitorThatEndedIsConfirmedOnceAllItsRobotsTellSo) {
  auto push = ended(PushState::kInterrupted, StepState::kRunning,
                    {reply_of("ganymede", kConfirmed), reply_of("io", kRunning)});
  EXPECT_TRUE(may_be_told_later(push));
  EXPECT_FALSE(told_later(push, 7)) << "io may still roll it back";
  push.replies[1].status = kConfirmed;
  const auto progress = told_later(push, 7);
  ASSERT_TRUE(progress);
  EXPECT_EQ(progress->state, PushState::kToldLater);
  EXPECT_EQ(progress->told_ns, 7);
  EXPECT_EQ(progress->steps[3].state, StepState::kDone);
  EXPECT_EQ(progress->steps[3].detail, "confirmed (told later) by ganymede, io");
}

TEST(ToldLater, APushThatFailedAtARobotThatDidNotAnswerIsConfirmedByItsLateAnswer) {
  const auto push = ended(PushState::kFailed, StepState::kFailed, {reply_of("io", kConfirmed)});
  const auto progress = told_later(push, 7);
  ASSERT_TRUE(progress);
  EXPECT_THAT(progress->steps[3].detail, HasSubstr("it had ended as: io is away"));
}

TEST(ToldLater, WhatEndedOtherwiseStaysAsItIs) {
  const std::vector<RobotReply> all{reply_of("io", kConfirmed)};
  EXPECT_FALSE(may_be_told_later(ended(PushState::kDone, StepState::kDone, all)));
  EXPECT_FALSE(may_be_told_later(ended(PushState::kCancelled, StepState::kCancelled, all)));
  EXPECT_FALSE(may_be_told_later(ended(PushState::kForeign, StepState::kRunning, all)));
  EXPECT_FALSE(may_be_told_later(ended(PushState::kToldLater, StepState::kDone, all)));
  EXPECT_FALSE(may_be_told_later(ended(PushState::kInterrupted, StepState::kRunning, {})))
      << "nobody was sent it";
  auto waits = ended(PushState::kInterrupted, StepState::kWaiting, all);
  waits.progress.steps[2].state = StepState::kRunning;
  EXPECT_FALSE(may_be_told_later(waits)) << "the others were not sent it";
  auto canary = ended(PushState::kFailed, StepState::kLeftOut, all);
  canary.progress.steps[2].state = StepState::kFailed;
  EXPECT_FALSE(may_be_told_later(canary)) << "it was ordered back";
  EXPECT_FALSE(told_later(canary, 7));
}

TEST(ToldLater, OfRobotsThatMayStillTellNothingIsKnownYet) {
  const auto push = ended(PushState::kDone, StepState::kDone,
                          {reply_of("callisto", kNoAnswer), reply_of("europa", kRejected),
                           reply_of("ganymede", kConfirmed), reply_of("io", kRunning)});
  std::string robots;
  for (const auto& reply : undecided(push)) robots += reply.robot + " ";
  EXPECT_EQ(robots, "callisto io ");
  auto under_way = push;
  under_way.progress.state = PushState::kRunning;
  EXPECT_TRUE(undecided(under_way).empty());
  under_way.progress.state = PushState::kForeign;
  EXPECT_TRUE(undecided(under_way).empty());
}

TEST(ToldLater, ALateReplyCountsOnlyIfItTellsMore) {
  const auto push = ended(PushState::kInterrupted, StepState::kRunning, {reply_of("io", kRunning)});
  msg::ProgramReply reply;
  reply.robot = "io";
  reply.stamp = wire::ros_time(1'250'000'000);
  for (const auto status : {kNoAnswer, kReceived, kRejected, kRunning}) {
    reply.status = static_cast<std::uint8_t>(status);
    EXPECT_FALSE(with_late_reply(push, reply));
  }
  reply.status = 99;
  EXPECT_FALSE(with_late_reply(push, reply));
  reply.status = static_cast<std::uint8_t>(kConfirmed);
  EXPECT_EQ(with_late_reply(push, reply)->status, kConfirmed);
  reply.robot = "europa";
  EXPECT_EQ(with_late_reply(push, reply)->latency_ms, 250) << "from the push to the robot's word";
}

TEST(ToldLaterProperty, APushIsConfirmedOnlyIfEachRobotSaidSo) {
  Random random(3);
  for (int play = 0; play < 5000; ++play) {
    std::vector<RobotReply> replies;
    for (const auto* robot : {"callisto", "ganymede", "io"})
      replies.push_back(reply_of(robot, static_cast<ReplyStatus>(random.below(7))));
    const auto push = ended(static_cast<PushState>(random.below(7)),
                            static_cast<StepState>(random.below(6)), replies);
    const auto progress = told_later(push, 7);
    if (!progress) continue;
    for (const auto& reply : replies) EXPECT_EQ(reply.status, kConfirmed);
    EXPECT_TRUE(push.progress.state == PushState::kInterrupted ||
                push.progress.state == PushState::kFailed);
    for (const auto& step : progress->steps)
      EXPECT_TRUE(step.state == StepState::kDone || step.state == StepState::kLeftOut);
  }
}

}  // namespace
}  // namespace galilean::monitor
