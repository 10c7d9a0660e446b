// SPDX-License-Identifier: BSD-3-Clause
// Gains and thresholds of the running program, as keys move and send them.
#include <gmock/gmock.h>

#include "tests/monitor/top/gains/office_program.h"
#include "tests/monitor/top/steered.h"

namespace galilean::monitor::top {
namespace {

using testing::ContainsRegex;
using testing::HasSubstr;
using testing::Not;

class Tuning : public Steered {
 protected:
  void SetUp() override {
    Steered::SetUp();
    for (const char* name : {"callisto", "ganymede", "io"}) run(name, "1 2", "3f2a91c0");
  }
  static std::string text_with(const std::string& gains) {
    return "motor_schemas: combine_forces: name: \"search\" inputs: \"noise\" \"robot\" gains: " +
           gains + " end end";
  }
  void run(const std::string& name, const std::string& gains, const std::string& hash) {
    msg::Program program;
    program.robot = name;
    program.hash = hash;
    program.files = {{.path = "office.bhdl", .text = text_with(gains)}};
    program.states = {{.name = "wander"}};
    tell_of_program(program);
    tell_of_catalog(name, catalog_to_json(office_catalog()));
  }
};

TEST_F(Tuning, TheGainsAreListedWithTheirValuesAndRanges) {
  press("g");
  EXPECT_THAT(screen(), HasSubstr("Gains of callisto"));
  EXPECT_THAT(screen(), ContainsRegex("▶ search · gain of noise +1 +──●─────────  0 to 5"));
  EXPECT_THAT(screen(), ContainsRegex("search · gain of robot +2 +──●─────────  0 to 10"));
  press(Key::kEscape);
  EXPECT_THAT(screen(), Not(HasSubstr("Gains of")));
}

TEST_F(Tuning, WhatIsMovedIsPushedByEnterInPlaceOfWhatRuns) {
  press("gj");
  press(Key::kRight);
  const std::string moved = screen();
  EXPECT_THAT(moved, ContainsRegex("▶ search · gain of robot +2\\.0[0-9]* .*runs 2"));
  EXPECT_FALSE(pusher.wished);
  press(Key::kEnter);
  ASSERT_TRUE(pusher.wished);
  EXPECT_EQ(pusher.pushed, "at once");
  EXPECT_EQ(pusher.wished->robots, std::vector<std::string>{"callisto"});
  EXPECT_EQ(pusher.wished->replaces, "3f2a91c0");
  EXPECT_THAT(pusher.wished->reason, HasSubstr("search · gain of robot 2 → 2.0"));
  ASSERT_EQ(pusher.wished->files.size(), 1u);
  EXPECT_THAT(pusher.wished->files[0].text, HasSubstr("gains: 1 2.0"));
  pusher.told = {PushReport::Stage::kPushing, "Push", {}};
  EXPECT_THAT(screen(), HasSubstr("Gains of callisto: sent"));
}

TEST_F(Tuning, TheTeamIsReachedWhereAllRunTheSame) {
  press("G");
  EXPECT_THAT(screen(), HasSubstr("Gains of the team"));
  press(">");
  press(Key::kEnter);
  ASSERT_TRUE(pusher.wished);
  EXPECT_TRUE(pusher.wished->robots.empty());
  EXPECT_EQ(pusher.wished->replaces, "3f2a91c0");
}

TEST_F(Tuning, WhereRobotsRunDifferentProgramsOneIsToBeChosen) {
  tell_of({.robot = "io", .program_hash = "77777777"});
  press("G");
  EXPECT_THAT(screen(), HasSubstr("The robots run different programs. Choose one, and press g."));
  press(">");
  press(Key::kEnter);
  EXPECT_FALSE(pusher.wished);
}

TEST_F(Tuning, WhatTheRobotRunsIsWhatIsShownAndUndoPushesWhatRanBefore) {
  press("g<");
  press(Key::kEnter);
  const auto sent = pusher.wished->files[0].text;
  run("callisto", sent.substr(sent.find("gains: ") + 7, 3), "55556666");
  tell_of({.robot = "callisto", .program_hash = "55556666"});
  EXPECT_THAT(screen(), Not(HasSubstr("runs 1")));
  press("u");
  EXPECT_EQ(pusher.wished->files[0].text.find(text_with("1")), 0u);
  EXPECT_EQ(pusher.wished->replaces, "55556666");
}

TEST_F(Tuning, WhyNothingIsSentIsTold) {
  press("g");
  press(Key::kEnter);
  EXPECT_THAT(screen(), HasSubstr("No number was moved."));
  press(">");
  pusher.told.stage = PushReport::Stage::kPushing;
  press(Key::kEnter);
  EXPECT_THAT(screen(), HasSubstr("A push is under way"));
  pusher.why_not = "the monitor's operator token is needed to push";
  press(Key::kEnter);
  EXPECT_THAT(screen(), HasSubstr("Cannot push: the monitor's operator token"));
  EXPECT_FALSE(pusher.wished);
  press("x");
  EXPECT_THAT(screen(), Not(HasSubstr("runs 1")));
}

TEST_F(Tuning, StopAllWorksOverTheList) {
  press("g.");
  EXPECT_EQ(said, Said{"hold"});
}

}  // namespace
}  // namespace galilean::monitor::top
