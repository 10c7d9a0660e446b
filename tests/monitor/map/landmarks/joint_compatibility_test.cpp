// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/map/landmarks/joint_compatibility.h"

#include <gtest/gtest.h>

namespace galilean::monitor {
namespace {

constexpr double kCertain_rad = 0.01;

TEST(JointCompatibility, IsOfWhatLiesAsFarApart) {
  EXPECT_TRUE(are_jointly_compatible({1, 0}, {1.1, 0}, kCertain_rad));
  EXPECT_FALSE(are_jointly_compatible({1, 0}, {1.3, 0}, kCertain_rad));
  EXPECT_FALSE(are_jointly_compatible({1, 0}, {0.7, 0}, kCertain_rad));
}

// The camera's ranges err by a share of themselves.
TEST(JointCompatibility, AllowsMoreWhereMoreIsApart) {
  EXPECT_FALSE(are_jointly_compatible({1, 0}, {1.25, 0}, kCertain_rad));
  EXPECT_TRUE(are_jointly_compatible({3, 0}, {3.25, 0}, kCertain_rad));
}

TEST(JointCompatibility, IsOfWhatIsTurnedNoMoreThanTheHeadingMayBeWrong) {
  for (const double side : {-1.0, 1.0}) {
    const Vec2 turned = rotated({2, 0}, side * 0.5);
    EXPECT_FALSE(are_jointly_compatible({2, 0}, turned, kCertain_rad));
    EXPECT_TRUE(are_jointly_compatible({2, 0}, turned, 0.2));
  }
  EXPECT_FALSE(are_jointly_compatible({2, 0}, {-2, 0}, 0.2));
}

TEST(JointCompatibility, IsNeverOfWhatLiesTogether) {
  EXPECT_FALSE(are_jointly_compatible({0.2, 0}, {0.2, 0}, kCertain_rad));
  EXPECT_FALSE(are_jointly_compatible({0, 0}, {0, 0}, kCertain_rad));
}

}  // namespace
}  // namespace galilean::monitor
