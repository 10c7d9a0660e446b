// SPDX-License-Identifier: BSD-3-Clause
// What operators ordered a robot must outlive its program's death.
#include "robot/telemetry/hold_keeper.h"

#include <gmock/gmock.h>

#include "tests/robot/telemetry/telemetry_robot.h"

namespace galilean::robot {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using testing::Pair;

/// A robot whose keeper is called by hand, with the newest snapshot after each tick.
class HoldKeeperTest : public testing::Test {
 protected:
  /// Makes the keeper, as after a start with these orders.
  void begin(const std::string& held_by = "", bool out_of_service = false) {
    if (out_of_service) robot.executive->decommission();
    if (!held_by.empty()) robot.executive->hold();
    desk.emplace("io", *robot.executive, held_by);
    const TelemetrySource source{
        .robot = "io",
        .participant = *participant,
        .executive = *robot.executive,
        .tap = tap,
        .devices = {robot.port, robot.drive, robot.camera},
        .catalog = test_components().catalog(),
        .clock = robot.clock,
        .held_by = held_by,
        .keep_orders = [this](const std::string& by, bool out) { kept.emplace_back(by, out); }};
    keeper.emplace(source, *desk, problems);
    ASSERT_TRUE(robot.load(kWaits));
    round();
  }
  void round() {
    robot.tick();
    ASSERT_TRUE(tap.take());
    keeper->on_round(tap.newest());
  }
  [[nodiscard]] std::vector<std::string> told() const {
    std::vector<std::string> texts;
    for (const Problem& problem : problems.all()) texts.push_back(problem.text());
    return texts;
  }
  static msg::Command by(const std::string& author) {
    msg::Command command;
    command.author = author;
    return command;
  }

  std::unique_ptr<wire::Participant> participant =
      wire::Participant::join("hold_keeper", kDomain).value();
  SnapshotTap tap;
  TestRobot robot{1, {&tap}};
  ThreadProblems problems;
  std::vector<std::pair<std::string, bool>> kept;
  std::optional<BreakDesk> desk;
  std::optional<HoldKeeper> keeper;
};

TEST_F(HoldKeeperTest, EachChangeIsKeptOnce) {
  begin();
  EXPECT_THAT(kept, IsEmpty()) << "nothing has changed";
  desk->hold(by("anna"));
  round();
  round();
  robot.executive->decommission();
  round();
  desk->resume(by("anna"));
  round();
  robot.executive->commission();
  round();
  EXPECT_THAT(
      kept, ElementsAre(Pair("anna", false), Pair("anna", true), Pair("", true), Pair("", false)));
  EXPECT_THAT(told(), IsEmpty());
}

TEST_F(HoldKeeperTest, AHoldAfterAFaultIsNobodys) {
  begin();
  robot.executive->hold_after(FaultCause::kRestart);
  round();
  EXPECT_THAT(kept, IsEmpty());
}

TEST_F(HoldKeeperTest, AStopOfABreakPointOfTheTeamIsKeptToo) {
  begin();
  ASSERT_TRUE(robot.executive->stop_with_team());
  round();
  EXPECT_THAT(kept, ElementsAre(Pair("a break point", false)));
}

TEST_F(HoldKeeperTest, ANameOfAStrangerIsShortVisibleAndThere) {
  begin();
  desk->hold(by("\n" + std::string(500, 'x')));
  round();
  ASSERT_EQ(kept.size(), 1U);
  EXPECT_TRUE(kept[0].first.starts_with("U+000Axxx")) << kept[0].first;
  EXPECT_EQ(kept[0].first.size(), 64U);
  desk->hold(by(""));
  round();
  EXPECT_EQ(kept.back().first, "an operator");
}

TEST_F(HoldKeeperTest, ARobotThatIsHeldSinceBeforeSaysSoUntilItIsResumed) {
  begin("anna", true);
  const std::string sentence =
      "held: anna held it when the robot program died and was started again; resume it.";
  EXPECT_THAT(told(), ElementsAre(sentence));
  EXPECT_THAT(kept, IsEmpty()) << "it is kept already";
  robot.press(1);
  round();
  round();
  EXPECT_FALSE(robot.executive->step());
  EXPECT_THAT(told(), ElementsAre(sentence)) << "neither a bumper nor a step ends it";
  desk->resume(by("anna"));
  round();
  EXPECT_THAT(told(), IsEmpty());
  EXPECT_THAT(kept, ElementsAre(Pair("", true)));
  desk->hold(by("anna"));
  round();
  EXPECT_THAT(told(), IsEmpty()) << "that is a new hold";
}

}  // namespace
}  // namespace galilean::robot
