// SPDX-License-Identifier: BSD-3-Clause
#include "robot/devices/motor_drive.h"

#include <gtest/gtest.h>

#include <limits>

#include "tests/robot/devices/board_on_a_pipe.h"

namespace galilean::robot {
namespace {

class Motors : public testing::Test {
 protected:
  Motors() { robot.run(50); }
  double left_m() const { return robot.link.status().left_travel_m; }
  double right_m() const { return robot.link.status().right_travel_m; }

  BoardOnAPipe robot;
};

TEST_F(Motors, SpeedsFollowFromTicksAndTurnRadius) {
  EXPECT_NEAR(robot.drive.forward_speed_mps(), 100 / 325.0, 1e-12);
  EXPECT_NEAR(robot.drive.turning_speed_radps(), 100 / 325.0 / 0.185, 1e-12);
  EXPECT_NEAR(robot.drive.turn_radius_m(), 0.185, 1e-12);
}

TEST_F(Motors, ADistanceEndsWhereItShould) {
  MotorDriveSettings patient;
  patient.timeout_s = 30;
  robot.drive.configure(patient);
  robot.drive_once({.speed_mps = -0.2, .distance_limit_m = 0.5}, 5000);
  EXPECT_NEAR(left_m(), -0.5, 0.004);
  EXPECT_NEAR(right_m(), -0.5, 0.004);
}

TEST_F(Motors, AnAngleIsCounterClockwiseAndEndsWhereItShould) {
  MotorDriveSettings patient;
  patient.timeout_s = 30;
  robot.drive.configure(patient);
  robot.drive_once({.turn_rate_radps = 1, .angle_limit_rad = kPi / 2}, 4000);
  EXPECT_NEAR((right_m() - left_m()) / 2 / 0.185, kPi / 2, 0.03);
  EXPECT_NEAR(right_m() + left_m(), 0, 0.004);
}

TEST_F(Motors, OnACurveTheFirstLimitEndsBothWheels) {
  MotorDriveSettings patient;
  patient.timeout_s = 30;
  robot.drive.configure(patient);
  const DriveCommand curve{
      .speed_mps = 0.15, .turn_rate_radps = -0.3, .distance_limit_m = 0.45, .angle_limit_rad = 100};
  robot.drive_once(curve, 6000);
  EXPECT_NEAR((left_m() + right_m()) / 2, 0.45, 0.004);
  EXPECT_NEAR((right_m() - left_m()) / 2 / 0.185, -0.9, 0.03);
}

TEST_F(Motors, ACommandLastsForItsTimeoutWhereItIsRenewedAndNoLonger) {
  robot.drive_once({.speed_mps = 0.3}, 480);
  EXPECT_GT(robot.bench().outputs.left_pwm, 0);
  robot.drive.keep_moving();
  for (int i = 0; i < 10; ++i) {
    robot.run(BoardOnAPipe::kTick_ms);
    robot.drive.keep_moving();
  }
  EXPECT_EQ(robot.bench().outputs.left_pwm, 0);
}

TEST_F(Motors, NoOldCommandIsRenewedAfterAStopOrALostLine) {
  robot.keep_driving({.speed_mps = 0.3}, 500);
  robot.drive.stop();
  robot.run(200);
  robot.drive_once({.speed_mps = 0.3}, 100);
  robot.pipe.connect(false);
  robot.run(300);
  robot.pipe.connect(true);
  for (int i = 0; i < 20; ++i) {
    robot.run(BoardOnAPipe::kTick_ms);
    robot.drive.keep_moving();
    ASSERT_EQ(robot.bench().outputs.left_pwm, 0) << i;
  }
}

TEST_F(Motors, ACommandThatIsNoNumberStops) {
  robot.keep_driving({.speed_mps = 0.3}, 500);
  robot.drive.drive({.speed_mps = std::numeric_limits<double>::quiet_NaN()});
  robot.run(400);
  EXPECT_NEAR(robot.bench().left.speed_counts_s(), 0, 20);
}

TEST(MotorDriveSettings, TakeThePapersSpellingAndOrder) {
  Declaration<MotorDriveSettings> declaration("motor_drive", ComponentKind::kOutputDevice);
  MotorDriveSettings::describe(declaration);
  const AttributeSpec* zones = declaration.spec().find("stright_dead_zones");
  ASSERT_NE(zones, nullptr);
  EXPECT_EQ(zones->name, "straight_dead_zones");
  MotorDriveSettings settings;
  settings.straight_dead_zones_pwm = {1, 2, -3, 4};
  const auto parameters = settings.parameters();
  EXPECT_EQ(parameters.straight_dead_zones.left_forward, 1);
  EXPECT_EQ(parameters.straight_dead_zones.right_forward, 2);
  EXPECT_EQ(parameters.straight_dead_zones.left_reverse, -3);
  EXPECT_EQ(parameters.straight_dead_zones.right_reverse, -4);
}

}  // namespace
}  // namespace galilean::robot
