// SPDX-License-Identifier: BSD-3-Clause
// Where a robot stops between states, and how it goes on.
#include <gmock/gmock.h>

#include "tests/robot/executive/branching_robot.h"

namespace galilean::robot {
namespace {

TEST(BreakPoints, TheMotorsStandStillInTheTickOfTheTransitionAndTheSchemasRun) {
  BranchingRobot robot;
  robot.stop_at("wander", "grab");
  robot.tick();
  ASSERT_TRUE(robot.drive.moving);
  journal.clear();
  robot.go_to("grab");
  EXPECT_EQ(robot.state(), "grab");
  EXPECT_FALSE(robot.drive.moving);
  EXPECT_TRUE(robot.executive->held());
  EXPECT_THAT(journal, testing::ElementsAre("+note", "note"));
  const Event& change = *robot.events.last(Event::Kind::kTransition);
  EXPECT_EQ(change.stopped_by, Hold::kBreakPoint);
  EXPECT_EQ(robot.executive->breaks().find(change.break_point)->author, "Anna");
  EXPECT_EQ(robot.events.standstill.hold, Hold::kBreakPoint);
  EXPECT_EQ(robot.events.standstill.stopped_at, change.number);
  robot.executive->resume();
  robot.tick();
  EXPECT_TRUE(robot.drive.moving);
  EXPECT_EQ(robot.events.standstill.hold, Hold::kNone);
}

struct Place {
  const char* from;
  const char* to;
  bool stops;  ///< where the robot goes from wander to grab
};

class PlacesOfBreakPoints : public testing::TestWithParam<Place> {};

TEST_P(PlacesOfBreakPoints, NameTheStateThatIsLeftOrEnteredOrBoth) {
  BranchingRobot robot;
  robot.stop_at(GetParam().from, GetParam().to);
  robot.tick();
  robot.go_to("grab");
  EXPECT_EQ(robot.drive.moving, !GetParam().stops);
}

INSTANTIATE_TEST_SUITE_P(All, PlacesOfBreakPoints,
                         testing::Values(Place{"", "grab", true}, Place{"wander", "", true},
                                         Place{"", "rest", false}, Place{"rest", "", false},
                                         Place{"wander", "rest", false},
                                         Place{"nowhere", "grab", false}));

TEST(BreakPoints, OfTwoThatMatchItIsTheOneThatStopsTheTeam) {
  BranchingRobot robot;
  robot.stop_at("wander", "grab");
  robot.set("", "grab", BreakKind::kStopTeam);
  robot.tick();
  robot.go_to("grab");
  const Event& change = *robot.events.last(Event::Kind::kTransition);
  EXPECT_EQ(robot.executive->breaks().find(change.break_point)->kind, BreakKind::kStopTeam);
}

TEST(BreakPoints, AStopThatLastsKeepsItsReason) {
  BranchingRobot robot;
  robot.stop_at("", "grab");
  robot.tick();
  robot.go_to("grab");
  const Standstill before = robot.events.standstill;
  robot.go_to("wander");
  EXPECT_EQ(robot.state(), "wander") << "schemas run while the robot stands";
  robot.go_to("grab");
  EXPECT_EQ(robot.events.standstill, before);
  EXPECT_EQ(robot.events.last(Event::Kind::kTransition)->stopped_by, Hold::kNone);
}

TEST(BreakPoints, AnOperatorsHoldIsStronger) {
  BranchingRobot robot;
  robot.stop_at("", "grab");
  robot.executive->hold();
  robot.go_to("grab");
  EXPECT_EQ(robot.events.standstill.hold, Hold::kOperator);
  EXPECT_EQ(robot.events.last(Event::Kind::kTransition)->stopped_by, Hold::kNone);
}

TEST(BreakPoints, OutOfServiceItStandsStillWhoeverStepsOrResumes) {
  BranchingRobot robot;
  robot.stop_at("", "grab");
  robot.tick();
  robot.executive->decommission();
  robot.go_to("grab");
  EXPECT_TRUE(robot.executive->step());
  robot.go_to("wander");
  robot.executive->resume();
  robot.tick();
  EXPECT_FALSE(robot.drive.moving);
}

TEST(BreakPoints, ARobotThatIsOutOfServiceStopsNobody) {
  BranchingRobot robot;
  robot.set("", "grab", BreakKind::kStopTeam);
  robot.tick();
  robot.executive->decommission();
  robot.go_to("grab");
  EXPECT_EQ(robot.events.last(Event::Kind::kTransition)->stopped_by, Hold::kNone);
  robot.executive->commission();
  robot.tick();
  EXPECT_TRUE(robot.drive.moving) << "it stands at no break point once it is in service";
}

TEST(BreakPoints, OutliveASwapAndStopWhereASwapChangesTheState) {
  BranchingRobot robot;
  robot.stop_at("", "grab");
  robot.stop_at("wander", "stray");
  robot.tick();
  ASSERT_TRUE(robot.load(branching_text("stray")));
  robot.tick();
  EXPECT_EQ(robot.state(), "stray");
  EXPECT_FALSE(robot.drive.moving);
  EXPECT_EQ(robot.events.last(Event::Kind::kTransition)->stopped_by, Hold::kBreakPoint);
  robot.executive->resume();
  robot.tick();
  ASSERT_TRUE(robot.drive.moving);
  robot.go_to("grab");
  EXPECT_FALSE(robot.drive.moving);
}

TEST(Steps, AStoppedRobotGoesOnToTheNextChangeOfState) {
  BranchingRobot robot;
  robot.stop_at("", "grab");
  robot.tick();
  robot.go_to("grab");
  ASSERT_TRUE(robot.executive->step());
  robot.tick();
  EXPECT_TRUE(robot.drive.moving);
  EXPECT_EQ(robot.events.standstill.hold, Hold::kStepping);
  EXPECT_FALSE(robot.executive->held());
  robot.go_to("wander");
  EXPECT_FALSE(robot.drive.moving);
  const Event& change = *robot.events.last(Event::Kind::kTransition);
  EXPECT_EQ(change.stopped_by, Hold::kStepEnd);
  EXPECT_EQ(robot.events.standstill.hold, Hold::kStepEnd);
  EXPECT_EQ(robot.events.standstill.stopped_at, change.number);
  ASSERT_TRUE(robot.executive->step());
  robot.go_to("rest");
  EXPECT_FALSE(robot.drive.moving) << "a step after a step";
}

TEST(Steps, ARunningRobotIsHeldAtItsNextChangeOfState) {
  BranchingRobot robot;
  robot.tick();
  ASSERT_TRUE(robot.executive->step());
  robot.tick();
  EXPECT_TRUE(robot.drive.moving);
  robot.go_to("rest");
  EXPECT_FALSE(robot.drive.moving);
}

TEST(Steps, ABreakPointAtTheEndOfAStepIsToldAsSuch) {
  BranchingRobot robot;
  robot.stop_at("", "grab");
  robot.tick();
  ASSERT_TRUE(robot.executive->step());
  robot.go_to("grab");
  EXPECT_EQ(robot.events.standstill.hold, Hold::kBreakPoint);
}

TEST(Steps, ARobotThatAnOperatorHoldsMakesNone) {
  BranchingRobot robot;
  robot.executive->hold();
  EXPECT_FALSE(robot.executive->step());
  robot.tick();
  EXPECT_FALSE(robot.drive.moving);
  EXPECT_EQ(robot.events.standstill.hold, Hold::kOperator);
}

TEST(Steps, AHoldEndsOneAndAResumeToo) {
  BranchingRobot robot;
  ASSERT_TRUE(robot.executive->step());
  robot.executive->hold();
  robot.executive->resume();
  robot.go_to("grab");
  EXPECT_TRUE(robot.drive.moving);
  ASSERT_TRUE(robot.executive->step());
  robot.executive->resume();
  robot.go_to("wander");
  EXPECT_TRUE(robot.drive.moving);
}

TEST(Steps, LetGoARobotThatStoppedWithItsTeam) {
  BranchingRobot robot;
  robot.tick();
  EXPECT_TRUE(robot.executive->stop_with_team());
  robot.tick();
  EXPECT_FALSE(robot.drive.moving);
  EXPECT_EQ(robot.events.standstill.hold, Hold::kTeam);
  EXPECT_TRUE(robot.executive->step());
  robot.tick();
  EXPECT_TRUE(robot.drive.moving);
  robot.executive->hold();
  EXPECT_FALSE(robot.executive->stop_with_team()) << "an operator's hold is stronger";
  EXPECT_FALSE(robot.executive->step());
}

}  // namespace
}  // namespace galilean::robot
