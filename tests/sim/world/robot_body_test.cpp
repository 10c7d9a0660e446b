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

// By hand for a straight run: m = 4.5 + 2 · 0.6 kg, K = 2 · 12 N · 0.81 / 0.6 m/s, dry friction
// 2 · 12 N · 0.19, so that a short takes m/K · ln(1 + K v / friction) = 0.20 s, and a step more
// here.
TEST(RobotBody, AShortBrakesAndPowerBackwardsBrakesHarder) {
  const struct {
    std::int16_t pwm;
    double seconds;
    double metres;
  } cases[] = {{0, 0.21, 0.028}, {-1000, 0.06, 0.009}};
  for (const auto& expected : cases) {
    const auto world = world_of(bare_floor());
    run(*world, {606, 606, 0}, 2);
    const auto begin = world->robot(0).inputs().left_encoder_counts;
    double stopped_s = 0;
    std::int32_t counts = begin;
    for (int i = 0; i < 100; ++i) {
      const std::int32_t before = counts;
      run(*world, {expected.pwm, expected.pwm, 0}, World::kStep_s);
      counts = world->robot(0).inputs().left_encoder_counts;
      if (counts <= before) break;
      stopped_s += World::kStep_s;
    }
    EXPECT_NEAR(stopped_s, expected.seconds, 0.03) << expected.pwm;
    EXPECT_NEAR((counts - begin) / Treads::kCountsPerMetre, expected.metres, 0.004) << expected.pwm;
  }
}

TEST(RobotBody, StandsWhereDryFrictionStoppedIt) {
  const auto world = world_of(bare_floor());
  run(*world, {606, -606, 0}, 2);
  run(*world, {0, 0, 0}, 0.5);
  const auto stood_at = world->robot(0).inputs();
  const double heading_rad = world->robot(0).pose().heading_rad;
  run(*world, {150, -150, 0}, 1);
  run(*world, {0, 0, 0}, 1);
  EXPECT_EQ(world->robot(0).inputs().left_encoder_counts, stood_at.left_encoder_counts);
  EXPECT_EQ(world->robot(0).inputs().right_encoder_counts, stood_at.right_encoder_counts);
  EXPECT_NEAR(world->robot(0).pose().heading_rad, heading_rad, 1e-4);
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
