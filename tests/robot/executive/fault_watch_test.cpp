// SPDX-License-Identifier: BSD-3-Clause
// After a fault that lasted, nothing moves until somebody says so.
#include "robot/executive/fault_watch.h"

#include "tests/robot/executive/test_robot.h"

namespace galilean::robot {
namespace {

/// Drives in its only state, and looks if `looks`; bumper 1 means nothing to it.
std::string driving_text(bool looks = false) {
  return std::string(R"(
variables: image: name: "red" end
perceptual_schemas: look: name: "look" red_variable: "red" end end
motor_schemas: ahead: name: "ahead" speed: 0.2 end end
states: state: name: "go" )") +
         (looks ? "perceptual_schemas: \"look\" end " : "") + R"(motor_schemas: "ahead" end end end
)";
}

/// A robot that drives, and is held after faults.
struct HoldingRobot : TestRobot {
  explicit HoldingRobot(bool looks = false, bool holds = true)
      : TestRobot(1, {}, {}, test_components(), holds) {
    EXPECT_TRUE(load(driving_text(looks)));
    tick(2);
  }
  /// Loses the device for 30 ticks of 50 ms, and then has it back for three.
  void lose(std::atomic<bool>& answers) {
    answers = false;
    tick(30);
    answers = true;
    tick(3);
  }
  [[nodiscard]] Hold hold() const { return events.standstill.hold; }
};

TEST(FaultWatch, ARobotThatNothingEverAskedToHoldGoesOnByItself) {
  HoldingRobot robot(false, false);
  robot.lose(robot.port.answers);
  EXPECT_TRUE(robot.drive.moving);
  EXPECT_EQ(robot.events.fault, FaultReport{});
}

TEST(FaultWatch, AfterALineThatWasGoneForLongTheRobotIsHeldUntilItIsResumed) {
  HoldingRobot robot;
  EXPECT_TRUE(robot.drive.moving);
  robot.port.answers = false;
  robot.tick(30);
  EXPECT_EQ(robot.hold(), Hold::kFault) << "before the line is back";
  EXPECT_EQ(robot.events.fault.cause, FaultCause::kSerialLine);
  EXPECT_FALSE(robot.events.fault.over);
  robot.port.answers = true;
  const int commands = robot.drive.commands;
  robot.tick(200);
  EXPECT_EQ(robot.drive.commands, commands) << "it moved unasked";
  EXPECT_EQ(robot.hold(), Hold::kFault);
  EXPECT_EQ(robot.events.fault.cause, FaultCause::kSerialLine);
  EXPECT_TRUE(robot.events.fault.over);
  EXPECT_NEAR(to_seconds(robot.events.fault.lasted), 1.5, 0.11);
  robot.executive->resume();
  robot.tick();
  EXPECT_TRUE(robot.drive.moving);
  EXPECT_EQ(robot.events.fault, FaultReport{});
}

TEST(FaultWatch, AShortFaultHoldsNobody) {
  HoldingRobot robot;
  robot.port.answers = false;
  robot.tick(18);
  robot.port.answers = true;
  robot.tick(2);
  EXPECT_TRUE(robot.drive.moving);
  EXPECT_FALSE(robot.executive->held());
}

/// Loses the line for `gone` ticks, and then has it back for `well` ticks.
void flap(HoldingRobot& robot, int gone, int well) {
  robot.port.answers = false;
  robot.tick(gone);
  robot.port.answers = true;
  robot.tick(well);
}

TEST(FaultWatch, AFaultHoldsFromASecondOnAndNotBefore) {
  for (int gone = 1; gone <= 30; ++gone) {
    HoldingRobot robot;
    flap(robot, gone, 3);
    EXPECT_EQ(robot.executive->held(), gone > 20) << gone << " ticks of 50 ms";
    EXPECT_EQ(robot.drive.moving, gone <= 20) << gone;
  }
}

TEST(FaultWatch, ALineThatComesAndGoesIsOneFault) {
  HoldingRobot robot;
  flap(robot, 12, 10);
  EXPECT_FALSE(robot.executive->held()) << "0.6 s are short";
  EXPECT_TRUE(robot.drive.moving);
  flap(robot, 12, 3);
  EXPECT_EQ(robot.hold(), Hold::kFault) << "1.2 s in all";
  EXPECT_EQ(robot.events.fault.cause, FaultCause::kSerialLine);
  EXPECT_TRUE(robot.events.fault.over);
  EXPECT_NEAR(to_seconds(robot.events.fault.lasted), 1.3, 0.11)
      << "what it was well does not count";
  robot.executive->resume();
  robot.tick();
  EXPECT_TRUE(robot.drive.moving);
  flap(robot, 12, 3);
  EXPECT_FALSE(robot.executive->held()) << "somebody has let it go on since";
}

TEST(FaultWatch, ShortFaultsFarApartHoldNobody) {
  HoldingRobot robot;
  for (int i = 0; i < 10; ++i) {
    flap(robot, 15, 25);
    ASSERT_FALSE(robot.executive->held()) << i;
  }
  EXPECT_TRUE(robot.drive.moving);
}

TEST(FaultWatch, FaultsOfTwoDevicesAreNotAddedUp) {
  HoldingRobot robot(true);
  flap(robot, 15, 2);
  robot.camera.answers = false;
  robot.tick(15);
  robot.camera.answers = true;
  robot.tick(2);
  EXPECT_FALSE(robot.executive->held());
}

TEST(FaultWatch, TheDeviceThatIsStillGoneNamesTheFault) {
  HoldingRobot robot(true);
  robot.port.answers = false;
  robot.camera.answers = false;
  robot.tick(30);
  EXPECT_EQ(robot.events.fault.cause, FaultCause::kSerialLine);
  robot.port.answers = true;
  robot.tick(3);
  EXPECT_EQ(robot.events.fault.cause, FaultCause::kCamera);
  EXPECT_FALSE(robot.events.fault.over);
  robot.camera.answers = true;
  robot.tick(3);
  EXPECT_EQ(robot.events.fault.cause, FaultCause::kCamera);
  EXPECT_TRUE(robot.events.fault.over);
  EXPECT_EQ(robot.hold(), Hold::kFault);
}

TEST(FaultWatch, ASlowLoopDoesNotStandStill) {
  FaultWatch watch;
  const auto judge = [&](Duration since_last_tick) {
    return watch.judge({.now = Time{std::chrono::hours(1)},
                        .since_last_tick = since_last_tick,
                        .tick_period = std::chrono::seconds(1),
                        .health = {true, true, true}});
  };
  EXPECT_EQ(judge(std::chrono::milliseconds(1050)), FaultWatch::Verdict::kNothing);
  EXPECT_EQ(judge(std::chrono::milliseconds(2050)), FaultWatch::Verdict::kHold);
}

TEST(FaultWatch, EveryDeviceThatTheProgramUsesCounts) {
  HoldingRobot driven;
  driven.lose(driven.drive.answers);
  EXPECT_EQ(driven.events.fault.cause, FaultCause::kMotorDrive);
  HoldingRobot seeing(true);
  seeing.lose(seeing.camera.answers);
  EXPECT_EQ(seeing.events.fault.cause, FaultCause::kCamera);
  EXPECT_FALSE(seeing.drive.moving);
  HoldingRobot blind;
  blind.lose(blind.camera.answers);
  EXPECT_FALSE(blind.executive->held()) << "it does not use the camera";
  EXPECT_TRUE(blind.drive.moving);
}

TEST(FaultWatch, ABoardThatWasRestartedIsSaidToBe) {
  HoldingRobot robot;
  robot.port.answers = false;
  robot.tick(30);
  robot.port.next.epoch = 1;
  robot.port.answers = true;
  robot.tick(3);
  EXPECT_EQ(robot.events.fault.cause, FaultCause::kBoard);
  EXPECT_EQ(robot.hold(), Hold::kFault);
}

TEST(FaultWatch, ALoopThatStoodStillHoldsTheRobotInTheVeryTick) {
  HoldingRobot robot;
  robot.clock.advance(std::chrono::milliseconds(1500));
  robot.tick();
  EXPECT_EQ(robot.hold(), Hold::kFault);
  EXPECT_FALSE(robot.drive.moving);
  EXPECT_EQ(robot.events.fault,
            (FaultReport{FaultCause::kStall, std::chrono::milliseconds(1550), true}));
}

TEST(FaultWatch, ADeviceThatComesAfterTheRobotIsNoFault) {
  TestRobot robot(1, {}, {}, test_components(), true);
  robot.port.answers = false;
  ASSERT_TRUE(robot.load(driving_text()));
  robot.tick(100);
  EXPECT_FALSE(robot.drive.moving);
  robot.port.answers = true;
  robot.tick(2);
  EXPECT_TRUE(robot.drive.moving);
}

TEST(FaultWatch, ABumperThatSomebodyPushesLetsItGoOn) {
  HoldingRobot robot;
  robot.lose(robot.port.answers);
  EXPECT_FALSE(robot.drive.moving);
  robot.press(1);
  robot.tick(2);
  EXPECT_FALSE(robot.executive->held());
  EXPECT_TRUE(robot.drive.moving);
}

TEST(FaultWatch, ABumperThatWasPressedAllTheWhileDoesNot) {
  HoldingRobot robot;
  robot.press(1);
  robot.lose(robot.port.answers);
  robot.tick(10);
  EXPECT_EQ(robot.hold(), Hold::kFault);
  robot.press(1, false);
  robot.tick(2);
  EXPECT_EQ(robot.hold(), Hold::kFault);
  robot.press(1);
  robot.tick(2);
  EXPECT_FALSE(robot.executive->held());
}

TEST(FaultWatch, WhoResumesItWhileTheLineIsGoneDoesNotLetItMoveLater) {
  HoldingRobot robot;
  robot.port.answers = false;
  robot.tick(30);
  robot.executive->resume();
  robot.tick();
  EXPECT_EQ(robot.hold(), Hold::kFault);
  robot.executive->push_bumper(1);
  robot.tick(3);
  EXPECT_EQ(robot.hold(), Hold::kFault) << "nor does a bumper";
  robot.port.answers = true;
  robot.tick(10);
  EXPECT_FALSE(robot.drive.moving);
}

TEST(FaultWatch, AnOperatorsHoldStaysTheOperators) {
  HoldingRobot robot;
  robot.executive->hold();
  robot.lose(robot.port.answers);
  EXPECT_EQ(robot.hold(), Hold::kOperator);
  robot.press(1);
  robot.tick(2);
  EXPECT_EQ(robot.hold(), Hold::kOperator) << "no bumper ends it";
  robot.executive->resume();
  robot.tick();
  EXPECT_TRUE(robot.drive.moving);
}

TEST(FaultWatch, WhoStopsARobotThatAFaultHoldsMakesTheHoldTheirs) {
  HoldingRobot robot;
  robot.lose(robot.port.answers);
  ASSERT_EQ(robot.hold(), Hold::kFault);
  robot.executive->hold();
  robot.tick();
  robot.press(1);
  robot.tick(2);
  EXPECT_EQ(robot.hold(), Hold::kOperator) << "a bumper ended it";
  EXPECT_FALSE(robot.drive.moving);
}

TEST(FaultWatch, AnOperatorsHoldOutlivesAFaultAlsoWhereFaultsHoldNobody) {
  HoldingRobot robot(false, false);
  robot.port.answers = false;
  robot.tick(30);
  robot.executive->hold();
  robot.tick(30);
  robot.port.answers = true;
  robot.tick(20);
  EXPECT_EQ(robot.hold(), Hold::kOperator);
  EXPECT_FALSE(robot.drive.moving);
  robot.executive->resume();
  robot.tick();
  EXPECT_TRUE(robot.drive.moving);
}

TEST(FaultWatch, AStepDoesNotEndTheHold) {
  HoldingRobot robot;
  robot.lose(robot.port.answers);
  EXPECT_FALSE(robot.executive->step());
  robot.tick();
  EXPECT_EQ(robot.hold(), Hold::kFault);
  EXPECT_FALSE(is_stop(robot.hold()));
}

TEST(FaultWatch, NoBumperMakesASecondRobotOfOneNameTheOnlyOne) {
  HoldingRobot robot;
  robot.executive->hold_after(FaultCause::kNamesake);
  robot.tick(2);
  robot.press(1);
  robot.tick(2);
  EXPECT_EQ(robot.hold(), Hold::kFault);
  EXPECT_EQ(robot.events.fault.cause, FaultCause::kNamesake);
  robot.executive->resume();
  robot.tick();
  EXPECT_TRUE(robot.drive.moving);
}

TEST(FaultWatch, AFaultThatIsKnownFromElsewhereHoldsTheRobotFromItsFirstTickOn) {
  TestRobot robot;
  ASSERT_TRUE(robot.load(driving_text()));
  robot.executive->hold_after(FaultCause::kRestart);
  robot.tick(5);
  EXPECT_EQ(robot.drive.commands, 0);
  EXPECT_EQ(robot.events.fault.cause, FaultCause::kRestart);
  robot.executive->resume();
  robot.tick();
  EXPECT_TRUE(robot.drive.moving);
}

}  // namespace
}  // namespace galilean::robot
