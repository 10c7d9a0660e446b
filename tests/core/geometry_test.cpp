// SPDX-License-Identifier: BSD-3-Clause
#include "core/geometry.h"

#include <gtest/gtest.h>

namespace galilean {
namespace {

constexpr double kClose = 1e-12;

TEST(Geometry, WrapsAnglesIntoOneTurn) {
  EXPECT_NEAR(wrap_angle(3 * kPi), kPi, kClose);
  EXPECT_NEAR(wrap_angle(-kPi), kPi, kClose);
  EXPECT_NEAR(wrap_angle(0.5 - 4 * kPi), 0.5, kClose);
}

TEST(Geometry, ClipsOnlyWhatIsTooLong) {
  EXPECT_EQ(clipped({0.3, 0.4}, 1), Vec2(0.3, 0.4));
  EXPECT_NEAR(clipped({30, 40}, 1).norm(), 1, kClose);
  EXPECT_NEAR(clipped({30, 40}, 1).x(), 0.6, kClose);
  EXPECT_EQ(clipped({0, 0}, 1), Vec2(0, 0));
}

TEST(Geometry, RobotFrameHasXRightAndYForward) {
  const Pose2 facing_x{{1, 2}, 0};
  EXPECT_TRUE(direction_to_global(facing_x, {0, 1}).isApprox(Vec2(1, 0)));
  EXPECT_TRUE(direction_to_global(facing_x, {1, 0}).isApprox(Vec2(0, -1)));
  EXPECT_TRUE(point_to_global(facing_x, {0.5, 2}).isApprox(Vec2(3, 1.5)));
}

TEST(Geometry, GoingToTheRobotFrameAndBackChangesNothing) {
  const Pose2 robot{{-3, 0.7}, 2.1};
  for (const Vec2& point : {Vec2(0, 0), Vec2(1, -4), Vec2(-2.5, 0.1)}) {
    EXPECT_TRUE(point_to_robot(robot, point_to_global(robot, point)).isApprox(point, kClose) ||
                point.isZero());
    EXPECT_NEAR((direction_to_global(robot, direction_to_robot(robot, point)) - point).norm(), 0,
                kClose);
  }
}

TEST(Geometry, BearingCountsCounterClockwiseFromAhead) {
  EXPECT_NEAR(bearing_rad({0, 1}), 0, kClose);
  EXPECT_NEAR(bearing_rad({-1, 0}), kPi / 2, kClose);
  EXPECT_NEAR(bearing_rad({1, 0}), -kPi / 2, kClose);
}

}  // namespace
}  // namespace galilean
