// SPDX-License-Identifier: BSD-3-Clause
#include "core/device/bumpers.h"
#include "tests/robot/motor/force_test.h"

namespace galilean::robot {
namespace {

constexpr double kDegree = kPi / 180;
constexpr double kSpeed = 0.30;  ///< of the fake motors, m/s
constexpr double kTurn = 1.6;    ///< of the fake motors, rad/s

class MoveRobotTest : public ForceTest {
 protected:
  std::unique_ptr<Schema> schema(bool reverse = false, double safety_range_deg = 30) {
    variable<Force>("move").constant = false;
    variable<Bits>("bumpers");
    return make("move_robot", {{"input_force", "move"s},
                               {"shaft_variable", "shaft"s},
                               {"mask_variable", "bumpers"s},
                               {"max_distance_magnitude", 0.15},
                               {"safety_range", safety_range_deg * kDegree},
                               {"reverse", reverse}});
  }
  DriveCommand drive(Schema& move, Vec2 force, std::uint32_t pressed = 0) {
    advance();
    variable<Force>("move").write({force}, 1, tick.now, tick.number);
    variable<Bits>("bumpers").write({pressed}, 1, tick.now, tick.number);
    const int before = motor_drive.commands;
    move.run(tick);
    EXPECT_EQ(motor_drive.commands, before + 1);
    return motor_drive.last;
  }
  /// Force of `length`, `degrees` to the left of straight ahead.
  static Vec2 force(double degrees, double length = 1) {
    return length * unit_vector(kPi / 2 + degrees * kDegree);
  }
};

TEST_F(MoveRobotTest, DrivesAheadAsFastAsTheForceIsLong) {
  const auto move = schema();
  DriveCommand command = drive(*move, {0, 1});
  EXPECT_NEAR(command.speed_mps, kSpeed, kTolerance);
  EXPECT_NEAR(command.turn_rate_radps, 0, kTolerance);
  EXPECT_NEAR(command.distance_limit_m, 0.15, kTolerance);
  command = drive(*move, {0, 0.5});
  EXPECT_NEAR(command.speed_mps, kSpeed / 2, kTolerance);
  EXPECT_NEAR(command.distance_limit_m, 0.075, kTolerance);
  EXPECT_NEAR(drive(*move, {0, 7}).speed_mps, kSpeed, kTolerance);
}

TEST_F(MoveRobotTest, SteersInAnArcWithinTheSafetyRange) {
  const auto move = schema();
  for (const double degrees : {-30.0, -12.0, 12.0, 30.0 - 1e-9}) {
    const DriveCommand command = drive(*move, force(degrees));
    EXPECT_NEAR(command.turn_rate_radps, kTurn * degrees / 30, 1e-6) << degrees;
    EXPECT_NEAR(command.speed_mps, kSpeed * std::cos(degrees * kDegree), kTolerance) << degrees;
  }
}

TEST_F(MoveRobotTest, TurnsInPlaceBeyondTheSafetyRange) {
  const auto move = schema();
  for (const double degrees : {30.0 + 1e-6, 90.0, 180.0 - 1e-6, -30.0 - 1e-6, -120.0}) {
    const DriveCommand command = drive(*move, force(degrees));
    EXPECT_EQ(command.speed_mps, 0) << degrees;
    EXPECT_NEAR(command.turn_rate_radps, degrees > 0 ? kTurn : -kTurn, kTolerance) << degrees;
    EXPECT_NEAR(command.angle_limit_rad, std::abs(degrees) * kDegree, kTolerance) << degrees;
  }
}

TEST_F(MoveRobotTest, BacksUpOnlyWithReverse) {
  EXPECT_EQ(drive(*schema(false), {0, -1}).speed_mps, 0);
  const auto move = schema(true);
  EXPECT_NEAR(drive(*move, {0, -1}).speed_mps, -kSpeed, kTolerance);
  const DriveCommand arc = drive(*move, force(180 + 12));
  EXPECT_NEAR(arc.speed_mps, -kSpeed * std::cos(12 * kDegree), kTolerance);
  EXPECT_NEAR(arc.turn_rate_radps, kTurn * 12 / 30, 1e-6);  // its tail swings to where it goes
  EXPECT_NEAR(drive(*move, {0, 1}).speed_mps, kSpeed, kTolerance);
}

TEST_F(MoveRobotTest, PressedBumpersForbidTheirSide) {
  const auto move = schema(true);
  for (int bumper = 0; bumper < 8; ++bumper) {
    const double ahead = drive(*move, {0, 1}, 1U << bumper).speed_mps;
    const double back = drive(*move, {0, -1}, 1U << bumper).speed_mps;
    const bool in_front = bumper == 0 || bumper == 1 || bumper == 7;
    const bool behind = bumper == 3 || bumper == 4 || bumper == 5;
    EXPECT_EQ(ahead == 0, in_front) << "bumper " << bumper;
    EXPECT_EQ(back == 0, behind) << "bumper " << bumper;
  }
}

TEST_F(MoveRobotTest, DoesNotLeanOnAPressedBumperInAnArcThatLeadsAwayFromIt) {
  const auto move = schema(false, 60);
  EXPECT_GT(drive(*move, force(50)).speed_mps, 0);
  const DriveCommand command = drive(*move, force(50), 1U << 7);  // front right
  EXPECT_EQ(command.speed_mps, 0);
  EXPECT_GT(command.turn_rate_radps, 0);
}

TEST_F(MoveRobotTest, TurnsAwayFromAPressedBumperAndStandsWhenWedged) {
  const auto move = schema();
  const DriveCommand aside = drive(*move, {0, 1}, 1U << 1);  // front left
  EXPECT_EQ(aside.speed_mps, 0);
  EXPECT_NEAR(aside.turn_rate_radps, -kTurn, kTolerance);
  EXPECT_EQ(drive(*move, {0, 1}, 1U << 0).turn_rate_radps, 0);
  EXPECT_EQ(drive(*move, force(-20), 0xFF).speed_mps, 0);
  EXPECT_EQ(drive(*move, force(-20), 0xFF).turn_rate_radps, 0);
}

TEST_F(MoveRobotTest, ABumperOnTheLeftIsTheMirrorOfThatOnTheRight) {
  const auto move = schema();
  for (int left = 1; left < 4; ++left)
    for (const double degrees : {-60.0, -40.0, -20.0, 0.0, 20.0, 40.0, 60.0}) {
      const DriveCommand one = drive(*move, force(degrees), 1U << left);
      const DriveCommand other = drive(*move, force(-degrees), 1U << (8 - left));
      EXPECT_NEAR(one.speed_mps, other.speed_mps, kTolerance) << left << " at " << degrees;
      EXPECT_NEAR(one.turn_rate_radps, -other.turn_rate_radps, 1e-6) << left << " at " << degrees;
    }
  EXPECT_LT(drive(*move, {0, 1}, 1U << 1).turn_rate_radps, 0) << "away from the front left";
  EXPECT_GT(drive(*move, {0, 1}, 1U << 7).turn_rate_radps, 0) << "away from the front right";
  EXPECT_LT(drive(*move, force(20), 1U << 2).turn_rate_radps, kTolerance) << "not to the left";
  EXPECT_GT(drive(*move, force(20), 1U << 6).turn_rate_radps, 0) << "but to the left";
}

TEST_F(MoveRobotTest, StandsWithoutAForceThatActsOrAShaft) {
  const auto move = schema();
  EXPECT_GT(drive(*move, {0, 1}).speed_mps, 0);
  advance();
  move->run(tick);  // nothing wrote the force in this tick
  EXPECT_EQ(motor_drive.last.speed_mps, 0);
  EXPECT_EQ(drive(*move, {0, 0}).speed_mps, 0);
  shaft().reset(tick.now);
  EXPECT_EQ(drive(*move, {0, 1}).speed_mps, 0);
}

TEST_F(MoveRobotTest, FollowsAConstantForce) {
  const auto move = schema(true);
  auto& back = variable<Force>("move");
  back.constant = true;
  back.write({{0, -1}}, 1, tick.now, 0);
  advance(3600);
  shaft().mark_written(1, tick.now, tick.number);
  move->run(tick);
  EXPECT_NEAR(motor_drive.last.speed_mps, -kSpeed, kTolerance);
}

TEST(Bumpers, StandCounterClockwiseFromTheFront) {
  EXPECT_TRUE(bumper_direction(0).isApprox(Vec2(0, 1)));
  EXPECT_TRUE(bumper_direction(2).isApprox(Vec2(-1, 0)));
  EXPECT_TRUE(bumper_direction(6).isApprox(Vec2(1, 0)));
}

class MoveGripperTest : public SchemaTest {};

TEST_F(MoveGripperTest, FollowsABitWhileItIsValid) {
  using namespace std::string_literals;
  auto& bits = variable<Bits>("grip");
  const auto grip = make("move_gripper", {{"bits_variable", "grip"s}, {"bit_index", 3.0}});
  grip->run(tick);
  EXPECT_TRUE(comm_port.commands.empty());
  bits.write({1U << 3}, 1, tick.now, tick.number);
  grip->run(tick);
  bits.write({~(1U << 3)}, 1, tick.now, tick.number);
  grip->run(tick);
  EXPECT_EQ(comm_port.commands, (std::vector{GripperCommand::kClose, GripperCommand::kOpen}));
}

TEST_F(MoveGripperTest, ObeysItsCommandWhereThereIsNoBit) {
  make("move_gripper", {{"command", std::string("open")}})->run(tick);
  make("move_gripper", {{"command", std::string("close")}})->run(tick);
  EXPECT_EQ(comm_port.commands, (std::vector{GripperCommand::kOpen, GripperCommand::kClose}));
}

}  // namespace
}  // namespace galilean::robot
