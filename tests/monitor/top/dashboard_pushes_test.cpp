// SPDX-License-Identifier: BSD-3-Clause
// Pushes from the dashboard: a file, the last good program, and one that was pushed before.
#include <gmock/gmock.h>

#include "core/wire/ros_time.h"
#include "tests/monitor/top/steered.h"

namespace galilean::monitor::top {
namespace {

using testing::ContainsRegex;
using testing::HasSubstr;
using testing::Not;

TEST_F(Steered, WhereNothingCanBePushedItSaysSoBeforehand) {
  pusher.why_not = "the monitor's operator token is needed to push";
  EXPECT_THAT(screen(), HasSubstr("cannot push"));
  press("p");
  EXPECT_THAT(screen(), HasSubstr("Cannot push: the monitor's operator token is needed to push"));
  EXPECT_FALSE(pusher.wished);
}

TEST_F(Steered, APushIsCheckedShownAndAskedFor) {
  press("P");
  press("office.bhdl");
  EXPECT_THAT(screen(), HasSubstr("Push which file? office.bhdl_"));
  press(Key::kEnter);
  ASSERT_TRUE(pusher.wished);
  EXPECT_EQ(pusher.wished->file, "office.bhdl");
  EXPECT_TRUE(pusher.wished->robots.empty());
  pusher.told = {PushReport::Stage::kReady, "Push office.bhdl 3f2a", {{"2 differences"}}};
  EXPECT_THAT(screen(), HasSubstr("2 differences"));
  EXPECT_THAT(screen(),
              HasSubstr("Push to all robots?  y yes   Esc no   c callisto runs it first"));
  press("cy");
  EXPECT_EQ(pusher.pushed, "with canary");
}

TEST_F(Steered, RestoringIsForTheChosenRobotAndMayBeLeft) {
  press("u");
  ASSERT_TRUE(pusher.wished);
  EXPECT_EQ(pusher.wished->file, "");
  EXPECT_EQ(pusher.wished->robots, std::vector<std::string>{"callisto"});
  pusher.told.stage = PushReport::Stage::kReady;
  press(Key::kEscape);
  EXPECT_EQ(pusher.cancelled, 1);
  EXPECT_EQ(pusher.pushed, "");
}

/// A push so many seconds ago.
PastPush pushed(const std::string& program, const std::string& hash, double age_s) {
  return {.pushed_ns = wire::wall_clock_ns() - static_cast<std::int64_t>(age_s * 1e9),
          .author = "Anna",
          .program = program,
          .hash = hash,
          .state = "done",
          .outcomes = {"callisto confirmed"}};
}

TEST_F(Steered, WhatWasPushedIsListedWithWhenByWhomAndTheAnswers) {
  press("w");
  EXPECT_EQ(pusher.listed, 1);
  EXPECT_THAT(screen(), HasSubstr("The monitor is asked."));
  pusher.past = {true, "", {}};
  EXPECT_THAT(screen(), HasSubstr("No program was pushed through this monitor yet."));
  pusher.past.pushes = {pushed("office.bhdl", "11112222", 200),
                        pushed("spin.bhdl", "33334444", 9e6)};
  pusher.past.pushes[1].targets = {"io"};
  EXPECT_THAT(screen(),
              ContainsRegex("▶ 3 min ago +11112222 +office.bhdl +Anna +done +to the team"));
  EXPECT_THAT(screen(), HasSubstr("Pushed by Anna to the team: callisto confirmed"));
  EXPECT_THAT(screen(), ContainsRegex("20[0-9][0-9]-[0-9][0-9]-[0-9][0-9] +33334444 +spin.bhdl"));
  press("j");
  EXPECT_THAT(screen(), HasSubstr("Pushed by Anna to io: callisto confirmed"));
  press(Key::kEscape);
  EXPECT_THAT(screen(), Not(HasSubstr("33334444")));
}

TEST_F(Steered, AProgramFromTheListIsComparedAndPushedAfterAYes) {
  msg::Program program;
  program.robot = "callisto";
  program.hash = "11112222";
  program.files = {{.path = "office.bhdl", .text = "states: end"}};
  program.states = {{.name = "wander"}};
  tell_of_program(program);
  pusher.past = {
      true, "", {pushed("office.bhdl", "11112222", 5), pushed("spin.bhdl", "33334444", 9)}};
  press("w");
  EXPECT_THAT(screen(), HasSubstr("runs now"));
  press(Key::kDown);
  press(Key::kEnter);
  ASSERT_TRUE(pusher.wished);
  EXPECT_EQ(pusher.wished->hash, "33334444");
  EXPECT_EQ(pusher.wished->robots, std::vector<std::string>{"callisto"});
  ASSERT_EQ(pusher.wished->runs.size(), 1u);
  EXPECT_EQ(pusher.wished->runs[0].text, "states: end");
  pusher.told = {PushReport::Stage::kReady, "Push spin.bhdl 33334444", {{"1 difference"}}};
  EXPECT_THAT(screen(), HasSubstr("1 difference"));
  EXPECT_EQ(pusher.pushed, "");
  press("y");
  EXPECT_EQ(pusher.pushed, "to all");
}

TEST_F(Steered, TheListSaysWhyItIsNotKnownAndAPushThatFailedHasNoProgramToRestore) {
  press("W");
  pusher.past.trouble = "nobody answers at http://127.0.0.1:8080";
  EXPECT_THAT(screen(), HasSubstr("nobody answers at http://127.0.0.1:8080"));
  press(Key::kEnter);
  pusher.past = {true, "", {pushed("broken.bhdl", "", 5)}};
  press(Key::kEnter);
  EXPECT_FALSE(pusher.wished);
}

TEST_F(Steered, AsLongAsAPushRunsTheListLeadsToIt) {
  press("W");
  pusher.past = {true, "", {pushed("spin.bhdl", "33334444", 9)}};
  pusher.told = {PushReport::Stage::kPushing, "Push of office.bhdl: running", {}};
  press(Key::kEnter);
  EXPECT_FALSE(pusher.wished);
  EXPECT_THAT(screen(), HasSubstr("Push of office.bhdl: running"));
}

}  // namespace
}  // namespace galilean::monitor::top
