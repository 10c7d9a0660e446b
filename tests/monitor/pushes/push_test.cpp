// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/pushes/push.h"

#include <gmock/gmock.h>

#include "monitor/pushes/history/push_messages.h"
#include "tests/monitor/pushes/push_fixture.h"

namespace galilean::monitor {
namespace {

using namespace std::chrono_literals;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::IsSupersetOf;
using enum ReplyStatus;

std::vector<StepState> states(const Push& push) {
  std::vector<StepState> result;
  for (const auto& step : push.record().progress.steps) result.push_back(step.state);
  return result;
}

std::string detail(const Push& push, StepKind kind) {
  for (const auto& step : push.record().progress.steps)
    if (step.kind == kind) return step.detail;
  return "no such step";
}

PushState state(const Push& push) {
  return push.record().progress.state;
}

/// It has checked and is recorded; what it asked for so far is done.
void pass_check(Push& push, Time now = {}) {
  push.take(checks(), now);
  push.take(PushRecorded{}, now);
}

/// What it does to robots and trials, once it is checked.
std::vector<std::string> acts(Push& push) {
  auto words = words_of(push);
  std::erase_if(words, [](const auto& each) {
    return each == "tell" || each == "check" || each.starts_with("record");
  });
  return words;
}

/// The canary runs it since `now`, and it was told so.
Push on_probation(Time now) {
  Push push = ordered(order_for("io"));
  pass_check(push, now);
  push.take_reply(said("io", kRunning), now);
  (void)requests_of(push);
  return push;
}

TrialFigures figures(double now, double next) {
  const auto side = [](double score) {
    TrialSide result;
    result.runs = 8;
    result.score.mean = score;
    return result;
  };
  return {.now = side(now), .next = side(next), .duration_s = 120};
}

Push on_trial(const PushOrder& order) {
  Push push = ordered(order);
  pass_check(push);
  (void)requests_of(push);
  return push;
}

TEST(Push, WithoutTrialAndCanaryAllAreAskedAtOnce) {
  Push push = ordered(order_for());
  EXPECT_THAT(words_of(push), ElementsAre("check"));
  push.take(checks(), Time{});
  EXPECT_THAT(words_of(push), ElementsAre("record")) << "before anything of it is sent";
  push.take(PushRecorded{}, Time{});
  EXPECT_THAT(words_of(push), ElementsAre("send to the team", "tell"));
  EXPECT_FALSE(push.take_answer()) << "who ordered it waits for the robots";
  for (const auto* robot : {"io", "ganymede", "callisto"})
    push.take_reply(said(robot, kRunning), Time{20ms});
  EXPECT_EQ(state(push), PushState::kDone);
  EXPECT_THAT(states(push), ElementsAre(StepState::kDone, StepState::kLeftOut, StepState::kLeftOut,
                                        StepState::kDone));
  EXPECT_EQ(push.take_answer()->value().replies.size(), 3U);
}

TEST(Push, WhatDoesNotCheckIsSentToNobodyAndWasNeverThere) {
  Push push = ordered(order_for("io", true));
  EXPECT_FALSE(push.is_refused());
  push.take(does_not_check(), Time{});
  EXPECT_TRUE(push.is_refused());
  EXPECT_TRUE(push.is_over());
  EXPECT_THAT(words_of(push), ElementsAre("check")) << "it is neither recorded nor told";
  const auto answer = push.take_answer();
  EXPECT_EQ(answer->error().reason, Refusal::Reason::kBroken);
  EXPECT_EQ(answer->error().check->refused_by, "io");
}

TEST(Push, WhatCannotBeRecordedIsSentToNobody) {
  Push push = ordered(order_for("io", true));
  push.take(checks(), Time{});
  (void)requests_of(push);
  push.take(PushRecorded{Error{"the history of pushes: the disk is full"}}, Time{});
  EXPECT_EQ(state(push), PushState::kFailed);
  EXPECT_THAT(words_of(push), ElementsAre("tell"));
  EXPECT_EQ(detail(push, StepKind::kCheck), "the history of pushes: the disk is full");
  const auto answer = push.take_answer();
  EXPECT_EQ(answer->error().reason, Refusal::Reason::kUnavailable);
  EXPECT_EQ(answer->error().message,
            "the history of pushes: the disk is full; nothing was pushed.");
  EXPECT_FALSE(push.take_answer()) << "it is told once";
}

TEST(Push, WhatDdsDoesNotTakeHasFailed) {
  Push push = ordered(order_for());
  pass_check(push);
  push.take(SendFailed{}, Time{});
  EXPECT_EQ(state(push), PushState::kFailed);
  EXPECT_EQ(detail(push, StepKind::kRest), "DDS did not accept the program; try again");
  EXPECT_EQ(push.take_answer()->error().reason, Refusal::Reason::kUnavailable);
}

TEST(Push, TheMessageToRobotsHasWhatTheOrderSays) {
  auto order = order_for("io");
  order.targets = {"io", "ganymede", "callisto"};
  order.probation = 3s;
  Push push = ordered(order);
  push.take(ProgramChecked{CheckedProgram{kNewHash, {{"main.bhdl", "text"}}, "old"}}, Time{});
  push.take(PushRecorded{}, Time{});
  auto requests = requests_of(push);
  const auto* recorded = std::get_if<RecordPush>(&requests.at(1));
  ASSERT_TRUE(recorded);
  EXPECT_EQ(recorded->push.targets, order.targets) << "the history has whom it was meant for";
  const auto* sent = std::get_if<SendProgram>(&requests.at(2));
  ASSERT_TRUE(sent);
  EXPECT_EQ(sent->push.id, kPushId);
  EXPECT_EQ(sent->push.author, "balch");
  EXPECT_EQ(sent->push.hash, kNewHash);
  EXPECT_EQ(sent->push.replaces_hash, "old");
  EXPECT_EQ(sent->push.stamp.nanosec, 7U);
  EXPECT_EQ(sent->push.files.at(0).path, "main.bhdl");
  EXPECT_FLOAT_EQ(sent->push.probation_s, 5) << "for as long as it may be taken back";
  EXPECT_FALSE(sent->is_for_team);
}

/// Returns the length of probation that robots are sent.
float sent_probation_s(const std::string& canary, std::optional<Duration> probation) {
  auto order = order_for(canary);
  order.probation = probation;
  Push push = ordered(order);
  pass_check(push);
  for (const auto& request : requests_of(push))
    if (const auto* sent = std::get_if<SendProgram>(&request)) return sent->push.probation_s;
  ADD_FAILURE() << "nothing was sent";
  return -1;
}

TEST(Push, AProbationOfNothingIsOrderedAndNotTheRobotsOwn) {
  EXPECT_EQ(sent_probation_s("", std::nullopt), 0) << "the robot's own";
  for (const char* canary : {"", "io"}) {
    EXPECT_GT(sent_probation_s(canary, Duration()), 0) << canary;
    EXPECT_LE(sent_probation_s(canary, Duration()), to_seconds(kReplyTimeout)) << canary;
  }
  EXPECT_LT(sent_probation_s("", Duration()), 0.01F) << "less than a tick";
}

TEST(Push, TheLongestProbationOfACanaryIsOneThatRobotsTake) {
  constexpr float kLongestThatRobotsTake_s = 3610;
  EXPECT_GE(sent_probation_s("io", Duration(1h)), 3600);
  EXPECT_LE(sent_probation_s("io", Duration(1h)), kLongestThatRobotsTake_s);
}

TEST(Push, TheOthersWaitUntilTheCanaryHasProvedTheProgram) {
  auto push = on_probation(Time{1s});
  push.update(Time{10s});
  EXPECT_THAT(acts(push), IsEmpty());
  push.update(Time{11s});
  EXPECT_THAT(acts(push), ElementsAre("send to callisto ganymede"));
  push.take_reply(said("callisto", kRunning), Time{11s});
  EXPECT_EQ(state(push), PushState::kRunning);
  push.take_reply(said("ganymede", kRunning), Time{11s});
  EXPECT_EQ(state(push), PushState::kDone);
}

TEST(Push, WhoOrdersOneThatTakesLongIsToldThatItIsAccepted) {
  auto push = on_probation(Time{});
  const auto answer = push.take_answer();
  ASSERT_TRUE(answer && *answer);
  EXPECT_EQ(answer->value().progress.state, PushState::kRunning);
  EXPECT_TRUE(push.cancel("balch"));
  EXPECT_FALSE(push.take_answer()) << "it is told once";
}

TEST(Push, ACanaryThatGoesBackKeepsTheProgramFromTheOthers) {
  auto push = on_probation(Time{});
  push.take_reply(said("io", kRolledBack, "it overran its ticks"), Time{3s});
  EXPECT_EQ(state(push), PushState::kFailed);
  EXPECT_THAT(acts(push), IsEmpty()) << "it went back by itself";
  EXPECT_EQ(detail(push, StepKind::kCanary), "io went back: it overran its ticks");
  push.update(Time{1h});
  EXPECT_THAT(acts(push), IsEmpty());
}

TEST(Push, ACanaryThatRefusesIsNotTakenBack) {
  Push push = ordered(order_for("io"));
  pass_check(push);
  (void)requests_of(push);
  push.take_reply(said("io", kRejected, "the serial line is down"), Time{});
  EXPECT_EQ(state(push), PushState::kFailed);
  EXPECT_THAT(acts(push), IsEmpty());
}

TEST(Push, ACanaryThatDoesNotAnswerOrFallsSilentIsTakenBack) {
  Push mute = ordered(order_for("io"));
  pass_check(mute);
  (void)requests_of(mute);
  mute.update(Time{kReplyTimeout});
  EXPECT_EQ(state(mute), PushState::kFailed);
  EXPECT_THAT(acts(mute), ElementsAre("roll back io"));

  auto lost = on_probation(Time{});
  lost.see_canary(true, kNewHash, Time{4s});
  EXPECT_THAT(detail(lost, StepKind::kCanary), HasSubstr("fell silent"));
  EXPECT_THAT(acts(lost), ElementsAre("roll back io"));
}

TEST(Push, SomebodyElsesProgramOnTheCanaryEndsIt) {
  auto push = on_probation(Time{});
  push.see_canary(false, "old", Time{100ms});
  EXPECT_FALSE(push.is_over()) << "that state was on its way already";
  push.see_canary(false, "theirs", Time{3s});
  EXPECT_EQ(state(push), PushState::kFailed);
}

TEST(Push, CancellingTakesTheCanaryBackAndBeginsNothingMore) {
  auto push = on_probation(Time{});
  EXPECT_TRUE(push.cancel("balch"));
  EXPECT_EQ(state(push), PushState::kCancelled);
  EXPECT_THAT(states(push), ElementsAre(StepState::kDone, StepState::kLeftOut,
                                        StepState::kCancelled, StepState::kLeftOut));
  EXPECT_EQ(detail(push, StepKind::kCanary), "cancelled by balch");
  const auto asked = requests_of(push);
  const auto* back = std::get_if<RollBack>(&asked.at(0));
  ASSERT_TRUE(back);
  EXPECT_EQ(back->order_id, kRollbackId);
  EXPECT_EQ(back->robot, "io");
  EXPECT_EQ(back->hash, kNewHash);
  EXPECT_EQ(back->reason, "cancelled by balch");
  const auto again = push.cancel("balch");
  ASSERT_FALSE(again);
  EXPECT_EQ(again.error().message, "This push is over: it is cancelled.");
  push.update(Time{1h});
  EXPECT_THAT(acts(push), IsEmpty());
}

TEST(Push, TheRobotThatWasOrderedBackAnswersForThePush) {
  auto push = on_probation(Time{});
  EXPECT_TRUE(push.cancel("balch"));
  (void)requests_of(push);
  auto back = said("io", kRolledBack, "cancelled by balch");
  back.id = kRollbackId;
  EXPECT_TRUE(push.is_meant_by(back));
  push.take_reply(back, Time{1s});
  EXPECT_THAT(words_of(push), ElementsAre("record reply of io"));
  EXPECT_EQ(push.record().replies.at(0).status, kRolledBack);
  back.status = static_cast<std::uint8_t>(kRejected);
  EXPECT_FALSE(push.is_meant_by(back)) << "it refuses the order, not the push";
}

TEST(Push, CancellingATrialEndsIt) {
  Push push = ordered(order_for("io", true));
  pass_check(push);
  EXPECT_THAT(acts(push), ElementsAre("try"));
  EXPECT_TRUE(push.cancel("balch"));
  EXPECT_THAT(acts(push), ElementsAre("end trial"));
  push.take(ProgramTried{figures(0, 10)}, Time{});
  EXPECT_THAT(acts(push), IsEmpty());
}

TEST(Push, CancellingWhileItIsCheckedSendsNothing) {
  Push push = ordered(order_for());
  EXPECT_TRUE(push.cancel("balch"));
  push.take(checks(), Time{});
  EXPECT_THAT(words_of(push), ElementsAre("check"));
  EXPECT_EQ(push.take_answer()->value().progress.state, PushState::kCancelled);
}

TEST(Push, WhenAllWereAskedItIsTooLateToCancel) {
  Push push = ordered(order_for());
  pass_check(push);
  const auto cancelled = push.cancel("balch");
  ASSERT_FALSE(cancelled);
  EXPECT_EQ(cancelled.error().reason, Refusal::Reason::kConflict);
  EXPECT_EQ(cancelled.error().message,
            "Every robot has been sent main.bhdl (new) already; push the program before it to go "
            "back.");
  EXPECT_EQ(state(push), PushState::kRunning);
}

TEST(Push, OnlyTryingPushesNothing) {
  auto order = order_for("io", true);
  order.trial.only = true;
  auto push = on_trial(order);
  push.see_trial(3, 16);
  EXPECT_EQ(detail(push, StepKind::kTry), "3 of 16 runs are over");
  push.take(ProgramTried{figures(0, 3)}, Time{});
  EXPECT_EQ(state(push), PushState::kDone);
  EXPECT_THAT(acts(push), IsEmpty());
  EXPECT_THAT(detail(push, StepKind::kTry),
              HasSubstr("scores 3 ± 0; the program that runs now scores 0 ± 0"));
  EXPECT_EQ(push.record().progress.trial["next"]["score"]["mean"], 3.0);
}

TEST(Push, AProgramThatScoresWorseIsNotPushed) {
  auto push = on_trial(order_for("io", true));
  push.take(ProgramTried{figures(30, 20)}, Time{});
  EXPECT_EQ(state(push), PushState::kFailed);
  EXPECT_THAT(acts(push), IsEmpty());
  EXPECT_THAT(detail(push, StepKind::kTry), HasSubstr("in simulation it scores 20"));
  EXPECT_FALSE(push.record().progress.trial.is_null()) << "the figures are kept";
}

TEST(Push, AProgramThatScoresWorseIsPushedWhereTheOrderSaysSo) {
  auto order = order_for("io", true);
  order.trial.even_if_worse = true;
  auto push = on_trial(order);
  push.take(ProgramTried{figures(30, 20)}, Time{});
  EXPECT_THAT(acts(push), ElementsAre("send to io"));
}

TEST(Push, WhatOnlyIsTriedMayScoreWorse) {
  auto order = order_for({}, true);
  order.trial.only = true;
  auto push = on_trial(order);
  push.take(ProgramTried{figures(30, 20)}, Time{});
  EXPECT_EQ(state(push), PushState::kDone);
  EXPECT_THAT(acts(push), IsEmpty());
}

TEST(Push, ATrialThatCannotBeHeldEndsIt) {
  auto push = on_trial(order_for("io", true));
  push.take(ProgramTried{Error{"no referee says in which arena the team is"}}, Time{});
  EXPECT_EQ(state(push), PushState::kFailed);
  EXPECT_THAT(acts(push), IsEmpty());
  EXPECT_EQ(detail(push, StepKind::kTry), "no referee says in which arena the team is");
}

TEST(Push, SaysWhoRefusedAndWhoDidNotAnswer) {
  Push push = ordered(order_for(), {"europa"});
  pass_check(push);
  push.take_reply(said("io", kRunning), Time{});
  push.take_reply(said("ganymede", kRejected, "no camera"), Time{});
  push.update(Time{kReplyTimeout});
  EXPECT_EQ(state(push), PushState::kFailed);
  EXPECT_EQ(detail(push, StepKind::kRest),
            "callisto has not answered; europa has not answered; ganymede refused it: no camera");
  EXPECT_THAT(words_of(push), IsSupersetOf({"record reply of callisto", "record reply of europa"}))
      << "the history names them";
  ASSERT_EQ(push.record().replies.size(), 4U) << "the silent one is listed";
  push.take_reply(said("io", kRolledBack), Time{9s});
  EXPECT_EQ(push.record().replies[3].status, kRolledBack) << "late words are heard";
}

TEST(Push, ARobotOfTheTeamThatIsAwayKeepsItFromBeingDone) {
  Push push = ordered(order_for(), {"europa"});
  pass_check(push);
  for (const auto* robot : {"io", "ganymede", "callisto"})
    push.take_reply(said(robot, kRunning), Time{20ms});
  EXPECT_EQ(state(push), PushState::kRunning) << "it may come back";
  push.update(Time{kReplyTimeout});
  EXPECT_EQ(state(push), PushState::kFailed);
  EXPECT_EQ(detail(push, StepKind::kRest), "europa has not answered");

  Push back = ordered(order_for(), {"europa"});
  pass_check(back);
  for (const auto* robot : {"io", "ganymede", "callisto", "europa"})
    back.take_reply(said(robot, kRunning), Time{20ms});
  EXPECT_EQ(state(back), PushState::kDone);
}

TEST(Push, OthersPushesAreAnsweredForAndCannotBeCancelled) {
  msg::ProgramPush message;
  message.id = kPushId;
  message.author = "collins";
  message.hash = kNewHash;
  message.files = {{"theirs.bhdl", "text"}};
  auto push = Push::of_others(message, targets_of({"callisto", "ganymede", "io"}), Time{});
  auto requests = requests_of(push);
  ASSERT_EQ(requests.size(), 1U) << "it is neither checked nor sent, and nobody is told";
  EXPECT_EQ(std::get<RecordPush>(requests[0]).progress.state, PushState::kForeign);
  const auto& recorded = std::get<RecordPush>(requests[0]);
  EXPECT_EQ(recorded.push.files[0].text, "text");
  EXPECT_EQ(push.record().hash, hash_of_files(message)) << "whatever hash it announces";
  ASSERT_EQ(recorded.progress.steps.size(), 1U);
  EXPECT_THAT(recorded.progress.steps[0].detail, testing::HasSubstr("it announces the hash new"));
  push.take_reply(said("io", kRunning), Time{});
  EXPECT_THAT(words_of(push), ElementsAre("record reply of io"));
  EXPECT_FALSE(push.cancel("balch"));
  EXPECT_EQ(push.record().program, "theirs.bhdl");
  EXPECT_FALSE(push.is_ours());
}

}  // namespace
}  // namespace galilean::monitor
