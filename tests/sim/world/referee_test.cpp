// SPDX-License-Identifier: BSD-3-Clause
#include "sim/world/referee.h"

#include <gtest/gtest.h>

namespace galilean::sim {
namespace {

const BodyTag kWall{BodyKind::kWall, 0};

Referee running(const Rules& rules = {}) {
  Referee referee(rules, 2);
  referee.start();
  return referee;
}

TEST(Referee, CountsHardTouchesOncePerPairAndPause) {
  Referee referee = running();
  referee.record_collision({0, kWall, 0.05});
  EXPECT_EQ(referee.collisions(), 0U);
  referee.record_collision({0, kWall, 0.2});
  referee.record_collision({0, kWall, 0.2});
  EXPECT_EQ(referee.collisions(), 1U);
  referee.record_collision({0, {BodyKind::kFurniture, 3}, 0.2});
  referee.record_collision({1, kWall, 0.2});
  EXPECT_EQ(referee.collisions(), 3U);
  referee.advance(5);
  referee.record_collision({0, kWall, 0.2});
  EXPECT_EQ(referee.robots()[0].collisions, 3U);
}

TEST(Referee, PiecesMayBeTouched) {
  Referee referee = running();
  referee.record_collision({0, {BodyKind::kPiece, 0}, 0.3});
  EXPECT_EQ(referee.collisions(), 0U);
}

TEST(Referee, NothingCountsBeforeTheStartOrAfterTheEnd) {
  Rules rules;
  rules.duration_s = 10;
  Referee referee(rules, 1);
  EXPECT_FALSE(referee.record_release(0, 0.1));
  referee.advance(5);
  EXPECT_EQ(referee.elapsed_s(), 0);
  referee.start();
  referee.advance(11);
  EXPECT_EQ(referee.phase(), Phase::kOver);
  EXPECT_EQ(referee.remaining_s(), 0);
  EXPECT_FALSE(referee.record_release(0, 0.1));
  EXPECT_EQ(referee.score(), 0);
}

TEST(Referee, ScoreIsPointsLessPenalties) {
  Rules rules;
  rules.points_per_piece = 7;
  rules.penalty_per_collision = 2;
  Referee referee = running(rules);
  EXPECT_TRUE(referee.record_release(1, rules.basket_zone_m));
  EXPECT_FALSE(referee.record_release(1, rules.basket_zone_m + 0.01));
  referee.record_collision({0, kWall, 1});
  EXPECT_EQ(referee.score(), 5);
  EXPECT_EQ(referee.robots()[1].deposited, 1U);
}

TEST(Referee, KeepsTheNewestCallsWithTheirPoints) {
  Rules rules;
  rules.points_per_piece = 7;
  rules.penalty_per_collision = 2;
  Referee referee = running(rules);
  referee.advance(3);
  referee.record_collision({0, kWall, 1});
  EXPECT_TRUE(referee.record_release(1, 0));
  ASSERT_EQ(referee.calls().size(), 2U);
  EXPECT_EQ(referee.calls()[0].what, RefereeCall::What::kCollision);
  EXPECT_EQ(referee.calls()[0].points, -2);
  EXPECT_EQ(referee.calls()[1].robot, 1U);
  EXPECT_EQ(referee.calls()[1].elapsed_s, 3);
  EXPECT_EQ(referee.calls()[1].points, 7);
  for (int i = 0; i < 100; ++i) EXPECT_TRUE(referee.record_release(0, 0));
  EXPECT_EQ(referee.calls().size(), 64U);
  EXPECT_EQ(referee.calls().front().robot, 0U);
}

}  // namespace
}  // namespace galilean::sim
