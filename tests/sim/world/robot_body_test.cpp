// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "tests/sim/scenes.h"

namespace galilean::sim {
namespace {

TEST(RobotBody, DeadZonesHoldTheMotorsAndAreWiderInATurn) {
  const auto world = world_of(bare_floor());
  run(*world, {180, 180, 0}, 1);
  EXPECT_EQ(world->robot(0).inputs().left_encoder_counts, 0);
  run(*world, {300, -300, 0}, 1);
  EXPECT_EQ(world->robot(0).inputs().left_encoder_counts, 0);
  run(*world, {300, 300, 0}, 1);
  EXPECT_GT(world->robot(0).inputs().left_encoder_counts, 100);
}

TEST(RobotBody, EncodersCountTheWayWhereNothingSlips) {
  const auto world = world_of(bare_floor());
  run(*world, {500, 500, 0}, 2);
  run(*world, {0, 0, 0}, 0.5);
  const double travelled_m = world->robot(0).inputs().left_encoder_counts / Treads::kCountsPerMetre;
  EXPECT_GT(travelled_m, 0.3);
  EXPECT_NEAR(world->robot(0).pose().position_m.x() - 3, travelled_m, 0.02);
}

TEST(RobotBody, EncodersDriftWhereTreadsSlip) {
  Scenario scenario = bare_floor();
  scenario.slip = Slip{};
  const auto world = world_of(scenario, 7);
  run(*world, {-600, 600, 0}, 10);
  run(*world, {0, 0, 0}, 0.5);
  const auto inputs = world->robot(0).inputs();
  const double believed_rad = (inputs.right_encoder_counts - inputs.left_encoder_counts) /
                              Treads::kCountsPerMetre / (2 * Treads::kTurnRadius_m);
  const double error_rad = std::abs(world->robot(0).pose().heading_rad - believed_rad);
  EXPECT_GT(error_rad, 0.01);
  EXPECT_LT(error_rad, 0.1 * believed_rad);
}

TEST(RobotBody, StallsAgainstAWallThatPressesItsFrontSwitches) {
  Scenario scenario = bare_floor();
  scenario.starts = {{{5.5, 3}, 0}};
  const auto world = world_of(scenario);
  run(*world, {500, 500, 0}, 3);
  EXPECT_LT(world->robot(0).pose().position_m.x(), 6 - Gripper::kReach_m + 0.03);
  EXPECT_TRUE(world->robot(0).inputs().bumpers & 0b10000011);
  run(*world, {-500, -500, 0}, 1);
  EXPECT_EQ(world->robot(0).inputs().bumpers, 0);
}

TEST(RobotBody, SwitchesAreNumberedCounterClockwiseFromTheFront) {
  // Drives or backs into the wall in the east, which then lies in the direction of that switch.
  const struct {
    double heading_deg;
    std::int16_t pwm;
    int number;
  } cases[] = {{0, 500, 0}, {225, -500, 3}, {135, -500, 5}};
  for (const auto& expected : cases) {
    Scenario scenario = bare_floor();
    scenario.starts = {{{5.6, 3}, expected.heading_deg * kPi / 180}};
    const auto world = world_of(scenario);
    int touched = 0;
    for (int i = 0; i < 400 && touched == 0; ++i) {
      run(*world, {expected.pwm, expected.pwm, 1000}, World::kStep_s);
      touched = world->robot(0).inputs().bumpers;
    }
    const auto is_pressed = [&](int number) { return (touched >> (number + 8) % 8 & 1) != 0; };
    EXPECT_TRUE(is_pressed(expected.number)) << expected.number << ": " << touched;
    for (int away = 2; away <= 6; ++away)
      EXPECT_FALSE(is_pressed(expected.number + away)) << expected.number << ": " << touched;
  }
}

TEST(RobotBody, ACornerThatMeetsATablePressesItsFrontSwitchAlone) {
  // A small table stands ahead of the front left or the front right corner, beside the gripper.
  const struct {
    double table_y_m;
    int bumpers;
  } cases[] = {{3 + 0.24, 0b00000010}, {3 - 0.24, 0b10000000}};
  for (const auto& expected : cases) {
    Scenario scenario = bare_floor();
    scenario.furniture = {{FurnitureKind::kTable, {{4, expected.table_y_m}, 0}, {0.2, 0.2}, 0.74}};
    const auto world = world_of(scenario);
    int touched = 0;
    for (int i = 0; i < 1000 && touched == 0; ++i) {
      run(*world, {500, 500, 1000}, World::kStep_s);
      touched = world->robot(0).inputs().bumpers;
    }
    EXPECT_EQ(touched, expected.bumpers) << "table at " << expected.table_y_m;
  }
}

TEST(RobotBody, ALoosePieceDoesNotPressASwitch) {
  Scenario scenario = bare_floor();
  scenario.placed = {{PieceKind::kCan, {3.6, 3.13}}};
  const auto world = world_of(scenario);
  for (int i = 0; i < 200; ++i) {
    run(*world, {500, 500, 0}, World::kStep_s);
    ASSERT_EQ(world->robot(0).inputs().bumpers, 0);
  }
}

TEST(RobotBody, PushedSwitchStaysUntilItIsLetGo) {
  const auto world = world_of(bare_floor());
  world->robot(0).push_bumpers(1);
  run(*world, {0, 0, 0}, 0.2);
  EXPECT_EQ(world->robot(0).inputs().bumpers, 1);
  world->robot(0).push_bumpers(0);
  EXPECT_EQ(world->robot(0).inputs().bumpers, 0);
}

}  // namespace
}  // namespace galilean::sim
