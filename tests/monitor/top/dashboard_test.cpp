// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/top/dashboard.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/monitor/top/steered.h"

namespace galilean::monitor::top {
namespace {

using std::chrono::milliseconds;
using std::chrono::seconds;
using testing::ContainsRegex;
using testing::HasSubstr;
using testing::Not;

TEST_F(Steered, HoldIsSaidAtOnceAndResumeAsks) {
  press("h");
  EXPECT_EQ(said, Said{"hold callisto"});
  EXPECT_THAT(screen(), HasSubstr("told callisto to hold"));
  press("R");
  EXPECT_THAT(screen(), HasSubstr("Resume all robots? y / n"));
  press("n");
  EXPECT_EQ(said.size(), 1u);
  press("ry");
  EXPECT_EQ(said, (Said{"hold callisto", "resume callisto"}));
}

TEST_F(Steered, ARobotIsTakenOutOfServiceAndBackAfterAYes) {
  press("d");
  EXPECT_THAT(screen(), HasSubstr("Decommission callisto, so that it stands until it is "
                                  "commissioned? y / n"));
  press("n");
  EXPECT_EQ(said, Said{});
  press("dy");
  EXPECT_EQ(said, Said{"decommission callisto"});
  tell_of({.robot = "callisto", .out_of_service = true});
  press("d");
  EXPECT_THAT(screen(), HasSubstr("Commission callisto, so that it serves again? y / n"));
  press("y");
  EXPECT_EQ(said.back(), "commission callisto");
  press("D");  // never the whole team at once
  EXPECT_EQ(said.size(), 2u);
}

TEST_F(Steered, WhoIsAskedAboutIsWhoIsTold) {
  Dashboard mistyped{{model, history, clock, voice(), pusher}, "calisto"};
  EXPECT_TRUE(mistyped.press({Key::kLetter, 'r'}));
  EXPECT_THAT(mistyped.draw(80, 24).text(), HasSubstr("Resume callisto? y / n"));
  EXPECT_TRUE(mistyped.press({Key::kLetter, 'y'}));
  EXPECT_EQ(said, Said{"resume callisto"});
}

TEST_F(Steered, StopAllIsSaidAtOnceAndAgainToThoseWhoHaveNotConfirmed) {
  press("?.");
  EXPECT_EQ(said, Said{"hold"});
  EXPECT_THAT(screen(), HasSubstr("STOP ALL: 0 of 3 stopped; callisto has not answered"));
  clock.advance(milliseconds(500));
  for (const char* name : {"callisto", "io"}) tell_of({.robot = name, .held = true});
  tell_of({.robot = "ganymede"});
  dashboard.update();
  EXPECT_EQ(said.size(), 1u);
  clock.advance(milliseconds(600));
  dashboard.update();
  EXPECT_EQ(said, (Said{"hold", "hold ganymede"}));
  EXPECT_THAT(screen(), HasSubstr("2 of 3 stopped; ganymede answers but has not stopped"));
  tell_of({.robot = "ganymede", .held = true});
  dashboard.update();
  EXPECT_THAT(screen(), HasSubstr("All 3 robots have stopped."));
  clock.advance(seconds(6));
  dashboard.update();
  EXPECT_THAT(screen(), Not(HasSubstr("STOP ALL:")));
}

TEST_F(Steered, ResumingOneRobotLeavesTheOthersToldToStop) {
  press(".ry");
  EXPECT_EQ(said, (Said{"hold", "resume callisto"}));
  clock.advance(milliseconds(1100));
  tell_of({.robot = "callisto"});
  dashboard.update();
  EXPECT_EQ(said.back(), "hold ganymede io");
  EXPECT_THAT(screen(), HasSubstr("STOP ALL: 0 of 2 stopped"));
  press("Ry");
  EXPECT_THAT(screen(), Not(HasSubstr("STOP ALL:")));
}

TEST_F(Steered, ARobotThatSomebodyElseResumesIsNotHeldAnew) {
  press(".");
  clock.advance(milliseconds(500));
  tell_of({.robot = "callisto", .held = true});
  dashboard.update();
  clock.advance(milliseconds(600));
  tell_of({.robot = "callisto"});
  dashboard.update();
  EXPECT_EQ(said.back(), "hold ganymede io");
}

TEST_F(Steered, StopAllWorksInASmallWindowAndWhileAQuestionIsAsked) {
  press("r.");
  EXPECT_EQ(said, Said{"hold"});
  EXPECT_THAT(dashboard.draw(40, 10).text(), HasSubstr("STOP ALL: 0 of 3"));
}

TEST_F(Steered, StopAllWorksWhileATextIsTyped) {
  press("p.");  // a person in a hurry looks at no prompt
  EXPECT_EQ(said, Said{"hold"});
  EXPECT_THAT(screen(), HasSubstr("Push which file? _  Enter, Esc, Ctrl-X STOP ALL"));
  press("a.b");
  EXPECT_EQ(said.size(), 1u);
  EXPECT_THAT(screen(), HasSubstr("Push which file? a.b_"));
  press(Key::kStop);
  EXPECT_EQ(said.size(), 2u);
  (void)dashboard.draw(40, 10);
  press(".");  // nobody sees that a text is typed
  EXPECT_EQ(said.size(), 3u);
  EXPECT_THAT(screen(), HasSubstr("Push which file? a.b_"));
  press(Key::kEscape);
  press("/.");
  EXPECT_EQ(said.size(), 4u);
}

TEST_F(Steered, SilentRobotsComeFirst) {
  clock.advance(seconds(3));
  for (const char* name : {"callisto", "ganymede"}) tell_of({.robot = name, .x_m = 1});
  dashboard.update();
  EXPECT_THAT(screen(), ContainsRegex("! ?I +io(.|\n)*callisto(.|\n)*ganymede"));
  EXPECT_THAT(screen(), HasSubstr("! io is silent, for 3.0 s"));
  press("a");
  EXPECT_THAT(screen(), HasSubstr("(seen)"));
  press("1h");
  EXPECT_EQ(said, Said{"hold io"});
}

TEST_F(Steered, WhatIsNotKnownOfARobotThatTheMapAloneKnowsIsLeftOpen) {
  clock.advance(seconds(60));
  tell_of_map_robot("europa", 14);
  dashboard.update();
  EXPECT_THAT(screen(), ContainsRegex("europa +– +14 s +– –"));
  EXPECT_THAT(dashboard.draw(80, 60).text(), HasSubstr("! europa is silent, for 14 s"));
}

TEST_F(Steered, WhileThePastIsShownTheAlarmsAreThoseOfNow) {
  clock.advance(seconds(3));
  for (const char* name : {"callisto", "ganymede"}) tell_of({.robot = name, .x_m = 1});
  dashboard.update();
  press(Key::kHome);
  EXPECT_THAT(screen(), HasSubstr("! now: io is silent, for 3.0 s"));
}

TEST_F(Steered, OnlyAlarmsThatStoodOnTheScreenAreSeen) {
  clock.advance(seconds(3));
  dashboard.update();
  const auto tall = [&] { return dashboard.draw(80, 60).text(); };
  EXPECT_THAT(tall(), ContainsRegex("callisto is silent(.|\n)*io is silent"));
  press("a");
  EXPECT_THAT(tall(), ContainsRegex("callisto is silent, for 3.0 s  .seen"));
  EXPECT_THAT(tall(), Not(ContainsRegex("(ganymede|io) is silent, for 3.0 s  .seen")));
  tell_of({.robot = "io"});
  dashboard.update();
  (void)tall();
  clock.advance(seconds(3));
  dashboard.update();  // io is silent again, which no screen has shown yet
  press("A");
  EXPECT_THAT(tall(), ContainsRegex("ganymede is silent, for 6.0 s  .seen"));
  EXPECT_THAT(tall(), Not(ContainsRegex("io is silent, for 3.0 s  .seen")));
}

TEST_F(Steered, TheFilterShowsTheChosenRobotAndThoseThatMatch) {
  press("/");
  press("GANY");
  EXPECT_THAT(screen(), HasSubstr("Robots with: GANY_"));
  EXPECT_THAT(screen(), HasSubstr("2 of 3 robots"));
  press(Key::kEnter);
  press("h");  // a letter is a command again
  EXPECT_EQ(said, Said{"hold callisto"});
  press("/");
  press(Key::kEscape);
  EXPECT_THAT(screen(), Not(HasSubstr("2 of 3 robots")));
}

TEST_F(Steered, AClickChoosesARobot) {
  (void)screen();
  EXPECT_TRUE(dashboard.press({Key::kClick, 0, 4, 30}));
  press("h");
  EXPECT_EQ(said, Said{"hold io"});
  EXPECT_TRUE(dashboard.press({Key::kWheelUp, 0, 3, 30}));
  press("h");
  EXPECT_EQ(said.back(), "hold ganymede");
}

TEST_F(Steered, GoingBackShowsWhatWasAndTheEndKeyTheNow) {
  for (int i = 0; i < 20; ++i, clock.advance(milliseconds(500)))
    tell_of({.state = i < 10 ? "earlier" : "later", .x_m = 0.1 * i});
  press("k");
  EXPECT_THAT(screen(), HasSubstr("later"));
  for (int i = 0; i < 7; ++i) press(Key::kLeft);
  EXPECT_THAT(screen(), HasSubstr("7.0 s ago (l: now)"));
  EXPECT_THAT(screen(), ContainsRegex("io +earlier"));
  for (int i = 0; i < 6; ++i) press(Key::kRight);
  EXPECT_THAT(screen(), ContainsRegex("io +later"));
  press(Key::kHome);
  EXPECT_THAT(screen(), HasSubstr("10 s ago"));
  press("l");
  EXPECT_THAT(screen(), Not(HasSubstr(" ago (l: now)")));
}

TEST_F(Steered, QuitsByItsKeyAlone) {
  EXPECT_FALSE(dashboard.press({Key::kLetter, 'q'}));
  press("?");
  EXPECT_THAT(screen(), HasSubstr("any other key goes back"));
  press("x/q");  // typed into the filter
  EXPECT_THAT(screen(), HasSubstr("Robots with: q_"));
}

}  // namespace
}  // namespace galilean::monitor::top
