// SPDX-License-Identifier: BSD-3-Clause
// Break points, locks and steps, as keys set them and as the screen shows them.
#include <gmock/gmock.h>

#include "core/wire/ros_time.h"
#include "monitor/top/screen/encoder.h"
#include "tests/monitor/top/steered.h"

namespace galilean::monitor::top {
namespace {

using std::chrono::milliseconds;
using std::chrono::seconds;
using testing::ContainsRegex;
using testing::HasSubstr;
using testing::Not;
namespace points = msg::BreakPoint_Constants;

class Breaking : public Steered {
 protected:
  void SetUp() override {
    Steered::SetUp();
    for (const char* name : {"callisto", "ganymede", "io"}) {
      msg::Program program;
      program.robot = name;
      program.name = "office";
      program.states = {{.name = "start"}, {.name = "wander"}, {.name = "grab"}};
      tell_of_program(program);
    }
    breaks.robot = "callisto";
    tell_of_breaks(breaks);
    dashboard.update();
  }
  /// The robot tells where it stops, as its answer to the newest order.
  void answer(std::string refused = "") {
    breaks.answers.push_back({std::to_string(said.size()), std::move(refused)});
    tell_of_breaks(breaks);
    dashboard.update();
  }
  /// The screen with the states alone beside the map.
  std::string states() {
    press(Key::kTab);
    const std::string shown = screen();
    for (int i = 0; i < 4; ++i) press(Key::kTab);
    return shown;
  }

  msg::Breaks breaks;
};

TEST_F(Breaking, AKeyTogglesABreakPointOnEnteringTheChosenState) {
  press("b");
  EXPECT_THAT(screen(), HasSubstr("Choose a state with J and K first"));
  EXPECT_EQ(said, Said{});
  press("JJ");  // the present state, then the one below
  EXPECT_THAT(states(), ContainsRegex("▶ wander *\n.*\\[grab\\]"));
  press("b");
  EXPECT_EQ(said, Said{"set :grab stop for callisto"});
  EXPECT_THAT(screen(), HasSubstr("told callisto about break points"));
  breaks.points = {{"", "grab", points::STOP}};
  answer();
  EXPECT_THAT(screen(), HasSubstr("callisto stops on entering grab"));
  EXPECT_THAT(states(), ContainsRegex("▶ wander *\n.* ●\\[grab\\]"));
  press("b");
  EXPECT_EQ(said.back(), "remove :grab for callisto");
}

TEST_F(Breaking, TheChoiceOfAStateEndsAtTheFirstAndTheLastAndWithEscape) {
  press("JJJJJ");
  EXPECT_THAT(states(), HasSubstr("[grab]"));
  press("KKKKK");
  EXPECT_THAT(states(), HasSubstr("[start]"));
  press(Key::kEscape);
  EXPECT_THAT(states(), Not(HasSubstr("[")));
}

TEST_F(Breaking, AClickOnAStateChoosesIt) {
  press(Key::kTab);
  const Canvas canvas = dashboard.draw(80, 24);
  int row = 0;
  while (row < 23 && canvas.line(row).find("grab") == std::string::npos) ++row;
  EXPECT_TRUE(dashboard.press({Key::kClick, 0, row, 50}));
  EXPECT_THAT(screen(), HasSubstr("[grab]"));
}

TEST_F(Breaking, ARefusalIsToldAndSoIsSilence) {
  press("JJb");
  answer("it would have 33 break points, and 32 are the most: take some off first");
  EXPECT_THAT(screen(), HasSubstr("callisto refused: it would have 33 break points"));
  press("n");
  EXPECT_EQ(said.back(), "step callisto");
  EXPECT_THAT(screen(), HasSubstr("told callisto to step"));
  clock.advance(milliseconds(1900));
  dashboard.update();
  EXPECT_THAT(screen(), Not(HasSubstr("did not answer")));
  clock.advance(milliseconds(200));
  dashboard.update();
  EXPECT_THAT(screen(), HasSubstr("callisto did not answer"));
}

TEST_F(Breaking, ARefusalOfACommandIsToldAndSilenceIsConsent) {
  press("s");
  EXPECT_EQ(said.back(), "start callisto");
  answer("nobody signed it");
  EXPECT_THAT(screen(), HasSubstr("callisto refused: nobody signed it"));
  press("s");
  clock.advance(seconds(3));
  dashboard.update();
  EXPECT_THAT(screen(), Not(HasSubstr("did not answer")));
}

TEST_F(Breaking, TheTeamIsSteppedAndWhoRefusesIsNamed) {
  press("N");
  EXPECT_EQ(said, Said{"step"});
  for (const char* name : {"ganymede", "io"}) {
    msg::Breaks answer;
    answer.robot = name;
    answer.answers = {{"1", name == std::string("io") ? "io is held by Anna" : ""}};
    tell_of_breaks(answer);
  }
  dashboard.update();
  EXPECT_THAT(screen(), HasSubstr("io refused: io is held by Anna"));
  answer();
  clock.advance(seconds(3));
  dashboard.update();
  EXPECT_THAT(screen(), Not(HasSubstr("did not answer")));
}

TEST_F(Breaking, OfTwoQuickOrdersEachHasItsAnswer) {
  press("JJbb");
  breaks.answers = {{"1", "it has enough"}, {"2", ""}};
  tell_of_breaks(breaks);
  dashboard.update();
  EXPECT_THAT(screen(), HasSubstr("callisto refused: it has enough; callisto stops on entering"));
  clock.advance(seconds(3));
  dashboard.update();
  EXPECT_THAT(screen(), Not(HasSubstr("did not answer")));
}

TEST_F(Breaking, AnAnswerCountsThoughAnotherOperatorsCameAfterIt) {
  press("JJb");
  breaks.answers = {{"1", ""}, {"another operator's", "there is no lock"}};
  tell_of_breaks(breaks);
  dashboard.update();
  EXPECT_THAT(screen(), HasSubstr("callisto stops on entering grab"));
  clock.advance(seconds(3));
  dashboard.update();
  EXPECT_THAT(screen(), Not(HasSubstr("did not answer")));
}

TEST_F(Breaking, AStoppedRobotSaysWhyAndWhatLetsItGo) {
  breaks.stopped = true;
  breaks.stopped_by = msg::Breaks_Constants::BREAK_POINT;
  breaks.break_point = {"", "wander", points::STOP};
  breaks.author = "Anna";
  breaks.stopped_at = 7;
  tell_of_breaks(breaks);
  tell_of({.robot = "callisto", .held = true});
  EXPECT_THAT(screen(), ContainsRegex("● callisto: stopped on entering wander \\(Anna's break "
                                      "point\\) +n step  r go on"));
  EXPECT_THAT(screen(), ContainsRegex("callisto +wander stopped"));
  press("k2");  // another robot
  EXPECT_THAT(screen(), Not(HasSubstr("n step  r go on")));
  EXPECT_THAT(screen(), ContainsRegex("callisto +wander stopped"));
}

TEST_F(Breaking, ARobotThatWaitsAtALockIsLetThroughFromTheList) {
  breaks.points = {{"", "start", points::STOP}, {"", "grab", points::LOCK}};
  breaks.waits_at_from = "wander";
  breaks.waits_at_to = "grab";
  breaks.stamp = wire::ros_time(103'000'000'000);
  breaks.waits_since = wire::ros_time(100'000'000'000);
  tell_of_breaks(breaks);
  EXPECT_THAT(screen(), ContainsRegex("■ callisto: waits at the lock wander -> grab for 3 s +B "
                                      "let through"));
  EXPECT_THAT(states(), HasSubstr(" ■grab"));
  press("B");
  EXPECT_THAT(screen(), HasSubstr("Break points of callisto"));
  EXPECT_THAT(screen(), ContainsRegex("▶ ■ lock +on entering grab  the robot waits here"));
  press(Key::kEnter);
  EXPECT_EQ(said, Said{"let_through wander:grab for callisto"});
  answer("it is in start, and not in wander: let it through when it waits there");
  EXPECT_THAT(screen(), HasSubstr("callisto refused: it is in start, and not in wander"));
  EXPECT_THAT(screen(), HasSubstr("l let through"));
}

TEST_F(Breaking, TheListChangesKindsRemovesAndClears) {
  breaks.points = {{"", "grab", points::STOP}, {"wander", "start", points::STOP_TEAM}};
  tell_of_breaks(breaks);
  press("Bt");
  EXPECT_EQ(said.back(), "set :grab stop_team for callisto");
  press(Key::kDown);
  EXPECT_THAT(screen(), ContainsRegex("▶ ● stop team +at wander -> start"));
  press("t");
  EXPECT_EQ(said.back(), "set wander:start lock for callisto");
  press("jx");  // there is none below
  EXPECT_EQ(said.back(), "remove wander:start for callisto");
  breaks.points.pop_back();
  answer();
  EXPECT_THAT(screen(), ContainsRegex("▶ ● stop +on entering grab"));
  press("C");
  EXPECT_EQ(said.back(), "clear for callisto");
  breaks.points.clear();
  answer();
  EXPECT_THAT(screen(), HasSubstr("It has none. J and K choose a state"));
  const auto before = said.size();
  press("xtl");
  EXPECT_EQ(said.size(), before);
  press(Key::kEscape);
  EXPECT_THAT(screen(), Not(HasSubstr("Break points of")));
}

TEST_F(Breaking, AKeyActsOnThePointThatWasSeenHoweverItsLineHasMoved) {
  breaks.points = {{"", "grab", points::STOP}, {"wander", "start", points::STOP}};
  tell_of_breaks(breaks);
  press("B");
  press(Key::kDown);
  screen();
  breaks.points = {
      {"", "wander", points::LOCK}, {"", "grab", points::STOP}, {"wander", "start", points::STOP}};
  tell_of_breaks(breaks);
  press("x");
  EXPECT_EQ(said.back(), "remove wander:start for callisto");
  breaks.points.pop_back();
  tell_of_breaks(breaks);
  press("x");
  EXPECT_EQ(said.size(), 1U) << "it is gone, and what stands in its line was not looked at yet";
  EXPECT_THAT(screen(), ContainsRegex("▶ ● stop +on entering grab"));
  press("x");
  EXPECT_EQ(said.back(), "remove :grab for callisto");
}

TEST_F(Breaking, KeysActNowAndSayItWhileThePastIsShown) {
  for (int i = 0; i < 2; ++i) {
    clock.advance(seconds(2));
    for (const char* name : {"callisto", "ganymede", "io"}) tell_of({.robot = name});
  }
  press(Key::kLeft);
  press("JJb");
  EXPECT_EQ(said, Said{"set :grab stop for callisto"});
  EXPECT_THAT(screen(), HasSubstr("now: told callisto about break points"));
  answer();
  EXPECT_THAT(screen(), HasSubstr("now: callisto stops on entering grab"));
  press("n");
  EXPECT_EQ(said.back(), "step callisto");
  EXPECT_THAT(screen(), HasSubstr("now: told callisto to step"));
  press("h");
  EXPECT_THAT(screen(), HasSubstr("now: told callisto to hold"));
  press("r");
  EXPECT_THAT(screen(), HasSubstr("now: Resume callisto? y / n"));
  press("n.");
  EXPECT_THAT(screen(), HasSubstr("now: STOP ALL: "));
  press("B");
  EXPECT_THAT(screen(), HasSubstr("Now: break points of callisto"));
  press(Key::kEscape);
  press("ln");
  EXPECT_THAT(screen(), Not(HasSubstr("now: ")));
}

TEST_F(Breaking, WhatLetAStoppedRobotGoIsNoHintInThePast) {
  breaks.stopped = true;
  breaks.stopped_by = msg::Breaks_Constants::STEP;
  clock.advance(seconds(2));
  tell_of_breaks(breaks);
  tell_of({.robot = "callisto", .held = true});
  EXPECT_THAT(screen(), HasSubstr("n step  r go on"));
  clock.advance(seconds(2));
  tell_of({.robot = "callisto"});
  press(Key::kLeft);
  EXPECT_THAT(screen(), HasSubstr("callisto: stopped after a step"));
  EXPECT_THAT(screen(), Not(HasSubstr("n step  r go on")));
}

TEST_F(Breaking, StopAllWorksOverTheList) {
  press("B.");
  EXPECT_EQ(said, Said{"hold"});
}

TEST_F(Breaking, ARobotThatTellsNothingOfBreakPointsIsGivenNone) {
  press("2");
  press("JJb");
  EXPECT_EQ(said, Said{});
  EXPECT_THAT(screen(), HasSubstr("ganymede tells nothing of break points."));
  press("B");
  EXPECT_THAT(screen(), HasSubstr("ganymede has told nothing about break points."));
}

TEST_F(Breaking, WhereTheLocaleIsAsciiTheSignsAreStillTold) {
  EXPECT_EQ(ascii_for(U'●'), '*');
  EXPECT_EQ(ascii_for(U'■'), '#');
}

}  // namespace
}  // namespace galilean::monitor::top
