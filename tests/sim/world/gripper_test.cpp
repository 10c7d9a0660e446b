// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "tests/sim/scenes.h"

namespace galilean::sim {
namespace {

constexpr std::int16_t kClosed = 1000;
constexpr std::int16_t kForward = 500;

Scenario with_piece(PieceKind kind, const Vec2& at) {
  Scenario scenario = bare_floor();
  scenario.placed = {{kind, at}};
  return scenario;
}

Vec2 piece_at(const World& world) {
  return from_b2(world.objects().pieces()[0].body->GetPosition());
}

TEST(Gripper, BeamIsBrokenByWhatStandsBetweenTheHandsOnly) {
  EXPECT_TRUE(world_of(with_piece(PieceKind::kCan, {3.26, 3.04}))->robot(0).inputs().beam_broken);
  EXPECT_FALSE(world_of(with_piece(PieceKind::kCan, {3.36, 3}))->robot(0).inputs().beam_broken);
  EXPECT_FALSE(world_of(with_piece(PieceKind::kCan, {3.26, 3.2}))->robot(0).inputs().beam_broken);
}

TEST(Gripper, OpenHandsPushACanThatClosedHandsCarryBackAndDrop) {
  const auto world = world_of(with_piece(PieceKind::kCan, {3.26, 3.02}));
  run(*world, {kForward, kForward, 0}, 1);
  EXPECT_GT(piece_at(*world).x(), 3.3);

  run(*world, {0, 0, kClosed}, 0.5);
  const double grabbed_x = piece_at(*world).x();
  run(*world, {-kForward, -kForward, kClosed}, 2);
  EXPECT_LT(piece_at(*world).x(), grabbed_x - 0.3);
  EXPECT_TRUE(world->robot(0).inputs().beam_broken);

  run(*world, {0, 0, 0}, 0.5);
  const double dropped_x = piece_at(*world).x();
  run(*world, {-kForward, -kForward, 0}, 1);
  EXPECT_NEAR(piece_at(*world).x(), dropped_x, 0.02);
  EXPECT_FALSE(world->robot(0).inputs().beam_broken);
}

TEST(Gripper, HoldsEveryKindOfPieceThroughATurn) {
  for (const PieceKind kind : {PieceKind::kCan, PieceKind::kCup, PieceKind::kWad}) {
    const auto world = world_of(with_piece(kind, {3.26, 3}));
    run(*world, {0, 0, kClosed}, 0.5);
    run(*world, {-500, 500, kClosed}, 4);
    EXPECT_TRUE(world->robot(0).gripper().held()) << to_string(kind);
    EXPECT_NEAR((piece_at(*world) - world->robot(0).pose().position_m).norm(), Gripper::kPocket_m,
                0.03);
  }
}

TEST(Gripper, ChairLegSlipsOutAsTheRobotBacksAway) {
  Scenario scenario = bare_floor();
  Chair chair;
  chair.pose.position_m = {3.262 + chair.pitch_m / 2, 3 + chair.pitch_m / 2};
  scenario.chairs = {chair};
  const auto world = world_of(scenario);
  run(*world, {0, 0, kClosed}, 0.5);
  ASSERT_TRUE(world->robot(0).gripper().held());
  EXPECT_TRUE(world->robot(0).inputs().beam_broken);
  run(*world, {-800, -800, kClosed}, 2);  // as the speed loops push when the robot lags
  EXPECT_FALSE(world->robot(0).gripper().held());
  EXPECT_FALSE(world->robot(0).inputs().beam_broken);
  const Vec2 moved = from_b2(world->objects().chairs()[0]->GetPosition()) - chair.pose.position_m;
  EXPECT_LT(moved.norm(), 0.1);
}

TEST(Gripper, HandsThatOpenBeforeAThinScreenAreNotCaughtInIt) {
  Scenario scenario = bare_floor();
  scenario.furniture = {{FurnitureKind::kScreen, {{3.5, 3}, kPi / 2}, {1.5, 0.06}, 1.2}};
  const auto world = world_of(scenario);
  run(*world, {kForward, kForward, kClosed}, 2);
  run(*world, {0, 0, 0}, 0.5);
  run(*world, {-kForward, -kForward, 0}, 1);
  EXPECT_LT(world->robot(0).pose().position_m.x(), 3);
}

TEST(Gripper, PieceReleasedBesideABasketIsThrownAwayAndOneElsewhereIsNot) {
  Scenario scenario = with_piece(PieceKind::kCup, {3.26, 3});
  scenario.baskets_m = {{3.26 + 0.45, 3}};
  for (const bool near : {true, false}) {
    if (!near) scenario.baskets_m = {{5, 5}};
    const auto world = world_of(scenario);
    world->referee().start();
    run(*world, {0, 0, kClosed}, 0.5);
    EXPECT_EQ(world->referee().deposited(), 0U);
    run(*world, {0, 0, 0}, 0.5);
    EXPECT_EQ(world->referee().deposited(), near ? 1U : 0U);
    EXPECT_EQ(world->objects().pieces()[0].body == nullptr, near);
    EXPECT_EQ(world->referee().score(), near ? 10 : 0);
  }
}

}  // namespace
}  // namespace galilean::sim
