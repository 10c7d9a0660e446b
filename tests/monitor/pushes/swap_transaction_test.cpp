// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/pushes/swap_transaction.h"

#include <gmock/gmock.h>

namespace galilean::monitor {
namespace {

using namespace std::chrono_literals;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using Act = SwapTransaction::Act;
namespace status = msg::ProgramReply_Constants;

msg::ProgramReply said(const std::string& robot, std::uint8_t status,
                       const std::string& message = {}) {
  msg::ProgramReply reply;
  reply.id = "1";
  reply.robot = robot;
  reply.hash = "new";
  reply.status = status;
  reply.message = message;
  return reply;
}

SwapPlan plan(const std::string& canary = {}, bool tries = false) {
  return {.id = "1",
          .awaited = {"callisto", "ganymede", "io"},
          .tries = tries,
          .canary = canary,
          .probation = 10s};
}

std::vector<std::string> states(const SwapTransaction& swap) {
  std::vector<std::string> result;
  for (const auto& step : swap.steps()) result.push_back(step.state);
  return result;
}

/// Checked, and the canary runs it since `now`.
SwapTransaction on_probation(Time now) {
  SwapTransaction swap(plan("io"), now);
  swap.checked({}, now);
  (void)swap.take_acts();
  swap.note(said("io", status::RUNNING), now);
  return swap;
}

TEST(SwapTransaction, WithoutTrialAndCanaryAllAreAskedAtOnce) {
  SwapTransaction swap(plan(), Time{});
  EXPECT_THAT(swap.take_acts(), ElementsAre(Act::kCheck));
  swap.checked({}, Time{});
  EXPECT_THAT(swap.take_acts(), ElementsAre(Act::kPushRest));
  for (const auto* robot : {"io", "ganymede", "callisto"})
    swap.note(said(robot, status::RUNNING), Time{20ms});
  EXPECT_EQ(swap.state(), "done");
  EXPECT_THAT(states(swap), ElementsAre("done", "left_out", "left_out", "done"));
}

TEST(SwapTransaction, WhatDoesNotCheckIsSentToNobody) {
  SwapTransaction swap(plan("io", true), Time{});
  (void)swap.take_acts();
  swap.checked("io has no component 'eye'", Time{});
  EXPECT_EQ(swap.state(), "failed");
  EXPECT_THAT(swap.take_acts(), IsEmpty());
  EXPECT_EQ(swap.steps()[0].detail, "io has no component 'eye'");
  EXPECT_FALSE(swap.has_reached_robots());
}

TEST(SwapTransaction, TheOthersWaitUntilTheCanaryHasProvedTheProgram) {
  auto swap = on_probation(Time{1s});
  swap.update(Time{10s});
  EXPECT_THAT(swap.take_acts(), IsEmpty());
  swap.update(Time{11s});
  EXPECT_THAT(swap.take_acts(), ElementsAre(Act::kPushRest));
  EXPECT_THAT(swap.rest(), ElementsAre("callisto", "ganymede"));
  swap.note(said("callisto", status::RUNNING), Time{11s});
  EXPECT_EQ(swap.state(), "running");
  swap.note(said("ganymede", status::RUNNING), Time{11s});
  EXPECT_EQ(swap.state(), "done");
}

TEST(SwapTransaction, ACanaryThatGoesBackKeepsTheProgramFromTheOthers) {
  auto swap = on_probation(Time{});
  swap.note(said("io", status::ROLLED_BACK, "it overran its ticks"), Time{3s});
  EXPECT_EQ(swap.state(), "failed");
  EXPECT_THAT(swap.take_acts(), IsEmpty()) << "it went back by itself";
  EXPECT_EQ(swap.steps()[2].detail, "io went back: it overran its ticks");
  swap.update(Time{1h});
  EXPECT_THAT(swap.take_acts(), IsEmpty());
}

TEST(SwapTransaction, ACanaryThatRefusesIsNotTakenBack) {
  SwapTransaction swap(plan("io"), Time{});
  swap.checked({}, Time{});
  (void)swap.take_acts();
  swap.note(said("io", status::REJECTED, "the serial line is down"), Time{});
  EXPECT_EQ(swap.state(), "failed");
  EXPECT_THAT(swap.take_acts(), IsEmpty());
}

TEST(SwapTransaction, ACanaryThatDoesNotAnswerOrFallsSilentIsTakenBack) {
  SwapTransaction mute(plan("io"), Time{});
  mute.checked({}, Time{});
  (void)mute.take_acts();
  mute.update(Time{SwapTransaction::kPatience});
  EXPECT_EQ(mute.state(), "failed");
  EXPECT_THAT(mute.take_acts(), ElementsAre(Act::kTakeBack));

  auto lost = on_probation(Time{});
  lost.see("io", true, "new", Time{4s});
  EXPECT_THAT(lost.steps()[2].detail, HasSubstr("fell silent"));
  EXPECT_THAT(lost.take_acts(), ElementsAre(Act::kTakeBack));
}

TEST(SwapTransaction, SomebodyElsesProgramOnTheCanaryEndsIt) {
  auto swap = on_probation(Time{});
  swap.see("io", false, "old", Time{100ms});
  EXPECT_FALSE(swap.over()) << "that state was on its way already";
  swap.see("io", false, "theirs", Time{3s});
  EXPECT_EQ(swap.state(), "failed");
}

TEST(SwapTransaction, CancellingTakesTheCanaryBackAndBeginsNothingMore) {
  auto swap = on_probation(Time{});
  EXPECT_TRUE(swap.cancel("balch"));
  EXPECT_EQ(swap.state(), "cancelled");
  EXPECT_THAT(states(swap), ElementsAre("done", "left_out", "cancelled", "left_out"));
  EXPECT_EQ(swap.steps()[2].detail, "cancelled by balch");
  EXPECT_THAT(swap.take_acts(), ElementsAre(Act::kTakeBack));
  EXPECT_FALSE(swap.cancel("balch")) << "it is over";
  swap.update(Time{1h});
  EXPECT_THAT(swap.take_acts(), IsEmpty());
}

TEST(SwapTransaction, CancellingATrialEndsIt) {
  SwapTransaction swap(plan("io", true), Time{});
  swap.checked({}, Time{});
  EXPECT_THAT(swap.take_acts(), ElementsAre(Act::kCheck, Act::kTry));
  EXPECT_TRUE(swap.cancel("balch"));
  EXPECT_THAT(swap.take_acts(), ElementsAre(Act::kEndTrial));
  swap.tried({}, "late", Time{});
  EXPECT_THAT(swap.take_acts(), IsEmpty());
}

TEST(SwapTransaction, WhenAllWereAskedItIsTooLateToCancel) {
  SwapTransaction swap(plan(), Time{});
  swap.checked({}, Time{});
  EXPECT_FALSE(swap.cancel("balch"));
  EXPECT_EQ(swap.state(), "running");
}

TEST(SwapTransaction, OnlyTryingPushesNothing) {
  auto only = plan("io", true);
  only.tries_only = true;
  SwapTransaction swap(only, Time{});
  swap.checked({}, Time{});
  EXPECT_THAT(swap.take_acts(), ElementsAre(Act::kCheck, Act::kTry));
  swap.tried({}, "better by 3", Time{});
  EXPECT_EQ(swap.state(), "done");
  EXPECT_THAT(swap.take_acts(), IsEmpty());
  EXPECT_EQ(swap.steps()[1].detail, "better by 3");
}

TEST(SwapTransaction, SaysWhoRefusedAndWhoDidNotAnswer) {
  auto some = plan();
  some.silent = {"europa"};
  SwapTransaction swap(some, Time{});
  swap.checked({}, Time{});
  swap.note(said("io", status::RUNNING), Time{});
  swap.note(said("ganymede", status::REJECTED, "no camera"), Time{});
  swap.update(Time{SwapTransaction::kPatience});
  EXPECT_EQ(swap.state(), "failed");
  EXPECT_EQ(swap.steps()[3].detail, "callisto has not answered; ganymede refused it: no camera");
  ASSERT_EQ(swap.answers().size(), 4U) << "the silent one is listed";
  swap.note(said("io", status::ROLLED_BACK), Time{9s});
  EXPECT_EQ(swap.answers()[3].status, "rolled_back") << "late words are heard";
}

TEST(SwapTransaction, OthersPushesAreAnsweredForAndCannotBeCancelled) {
  auto swap = SwapTransaction::of_others(plan(), Time{});
  EXPECT_THAT(swap.take_acts(), IsEmpty());
  EXPECT_TRUE(swap.note(said("io", status::RUNNING), Time{}));
  EXPECT_FALSE(swap.cancel("balch"));
}

}  // namespace
}  // namespace galilean::monitor
