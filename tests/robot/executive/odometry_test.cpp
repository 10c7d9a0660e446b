// SPDX-License-Identifier: BSD-3-Clause
#include "tests/robot/executive/test_robot.h"

namespace galilean::robot {
namespace {

constexpr const char* kShaft = R"(
variables:
  shaft: name: "shaft" position: (100, 0) heading: 90
  bits: name: "bumpers"
end
perceptual_schemas:
  bumper_scanner: name: "scan" bits_variable: "bumpers" end
end
states:
  state: name: "go" perceptual_schemas: "scan" end
    condition: bits_variable: "bumpers" bit_index: 0 bit_value: 1
      reset_variables: "shaft" new_state: "anew" end
  end
  state: name: "anew" end
end
)";
constexpr double kTrack_m = 0.4;

class Odometry_ : public testing::Test {
 protected:
  Odometry_() {
    EXPECT_TRUE(robot.load(kShaft));
    robot.port.next.left_travel_m = 7;
    robot.port.next.right_travel_m = 9;
    robot.tick();
  }
  void travel(double left_m, double right_m) {
    robot.port.next.left_travel_m += left_m;
    robot.port.next.right_travel_m += right_m;
    robot.tick();
  }
  [[nodiscard]] Pose2 pose() const { return robot.variable<Shaft>("shaft").value.pose; }
  void expect_pose(double x_m, double y_m, double heading_rad) const {
    EXPECT_NEAR(pose().position_m.x(), x_m, 1e-9);
    EXPECT_NEAR(pose().position_m.y(), y_m, 1e-9);
    EXPECT_NEAR(pose().heading_rad, heading_rad, 1e-9);
  }

  TestRobot robot;
};

TEST_F(Odometry_, BeginsWhereTheTextSaysWhateverTheBoardCountedBefore) {
  expect_pose(1, 0, kPi / 2);
  EXPECT_DOUBLE_EQ(robot.variable<Shaft>("shaft").certainty_at(robot.now()), 1);
}

TEST_F(Odometry_, FollowsAStraightLine) {
  travel(0.25, 0.25);
  expect_pose(1, 0.25, kPi / 2);
}

TEST_F(Odometry_, FollowsAnArcExactly) {
  // A quarter of a circle of radius 1 m to the left, in one tick.
  travel((1 - kTrack_m / 2) * kPi / 2, (1 + kTrack_m / 2) * kPi / 2);
  expect_pose(0, 1, kPi);
}

TEST_F(Odometry_, TurnsInPlaceAndWrapsTheHeading) {
  travel(-kTrack_m / 2 * kPi, kTrack_m / 2 * kPi);
  expect_pose(1, 0, -kPi / 2);
}

TEST_F(Odometry_, DoesNotJumpWhenTheBoardRestarts) {
  travel(1, 1);
  robot.port.next.epoch = 1;
  robot.port.next.left_travel_m = robot.port.next.right_travel_m = 0;
  robot.tick();
  expect_pose(1, 1, kPi / 2);
  travel(0.5, 0.5);
  expect_pose(1, 1.5, kPi / 2);
}

TEST_F(Odometry_, CatchesUpAfterSilenceAndFadesMeanwhile) {
  robot.port.answers = false;
  travel(0.5, 0.5);
  robot.tick(20 * 30 - 1);
  expect_pose(1, 0, kPi / 2);
  EXPECT_NEAR(robot.variable<Shaft>("shaft").certainty_at(robot.now()), 0.5, 1e-9);
  robot.port.answers = true;
  robot.tick();
  expect_pose(1, 0.5, kPi / 2);
  EXPECT_DOUBLE_EQ(robot.variable<Shaft>("shaft").certainty_at(robot.now()), 1);
}

/// Keeps the speeds that a tick shows.
struct SpeedWatch final : TickObserver {
  void on_event(const Event&) noexcept override {}
  void on_tick(const TickView& view) noexcept override {
    speed_mps = view.speed_mps;
    turn_rate_radps = view.turn_rate_radps;
  }
  double speed_mps = 0;
  double turn_rate_radps = 0;
};

TEST(ShownSpeed, IsThatOfTheWheelsAlsoAfterASwapToAProgramWithoutAShaft) {
  SpeedWatch shown;
  TestRobot robot(1, {&shown});
  ASSERT_TRUE(robot.load(kShaft));
  robot.port.next.left_speed_mps = 0.1;
  robot.port.next.right_speed_mps = 0.3;
  robot.tick(2);
  EXPECT_DOUBLE_EQ(shown.speed_mps, 0.2);
  EXPECT_NEAR(shown.turn_rate_radps, 0.2 / kTrack_m, 1e-12);
  ASSERT_TRUE(robot.load("state: name: \"go\" end\n"));
  robot.port.next.left_speed_mps = robot.port.next.right_speed_mps = 0;
  robot.tick(2);
  EXPECT_DOUBLE_EQ(shown.speed_mps, 0);
  EXPECT_DOUBLE_EQ(shown.turn_rate_radps, 0);
  robot.port.next.right_speed_mps = 0.4;
  robot.tick();
  EXPECT_DOUBLE_EQ(shown.speed_mps, 0.2);
}

TEST(ShownSpeed, IsNoneWhileTheLineIsDown) {
  SpeedWatch shown;
  TestRobot robot(1, {&shown});
  ASSERT_TRUE(robot.load(kShaft));
  robot.port.next.left_speed_mps = robot.port.next.right_speed_mps = 0.3;
  robot.tick(2);
  EXPECT_DOUBLE_EQ(shown.speed_mps, 0.3);
  robot.port.answers = false;
  robot.tick();
  EXPECT_DOUBLE_EQ(shown.speed_mps, 0) << "the speed before that is none of now";
  EXPECT_DOUBLE_EQ(shown.turn_rate_radps, 0);
  robot.port.answers = true;
  robot.tick();
  EXPECT_DOUBLE_EQ(shown.speed_mps, 0.3);
}

TEST_F(Odometry_, AShaftThatWasResetStartsOver) {
  travel(2, 2);
  robot.press(0);
  robot.tick();
  EXPECT_FALSE(robot.variable<Shaft>("shaft").valid_at(robot.now()));
  travel(0.5, 0.5);
  expect_pose(1, 0.5, kPi / 2);
}

}  // namespace
}  // namespace galilean::robot
