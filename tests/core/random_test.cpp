// SPDX-License-Identifier: BSD-3-Clause
#include "core/random.h"

#include <gtest/gtest.h>

namespace galilean {
namespace {

TEST(Random, SameSeedGivesTheSameNumbers) {
  Random a(7), b(7);
  for (int i = 0; i < 100; ++i) EXPECT_EQ(a.bits(), b.bits());
}

// Written down once: a change here changes every recorded hash of a simulation.
TEST(Random, FirstNumbersNeverChange) {
  Random random(1);
  EXPECT_EQ(random.bits(), 12966619160104079557ULL);
  EXPECT_EQ(random.bits(), 9600361134598540522ULL);
}

TEST(Random, ChildrenDifferAndDoNotDependOnWhatWasDrawn) {
  Random parent(7);
  const auto before = parent.child("io").bits();
  (void)parent.bits();
  EXPECT_EQ(parent.child("io").bits(), before);
  EXPECT_NE(parent.child("ganymede").bits(), before);
}

TEST(Random, UniformAndNormalHaveTheirMoments) {
  Random random(3);
  constexpr int kCount = 100000;
  double uniform = 0, normal = 0, square = 0;
  for (int i = 0; i < kCount; ++i) {
    const double u = random.uniform(2, 4);
    ASSERT_GE(u, 2);
    ASSERT_LT(u, 4);
    uniform += u;
    const double n = random.normal();
    normal += n;
    square += n * n;
  }
  EXPECT_NEAR(uniform / kCount, 3, 0.01);
  EXPECT_NEAR(normal / kCount, 0, 0.02);
  EXPECT_NEAR(square / kCount, 1, 0.03);
}

TEST(Random, BelowReachesEveryNumberAndNoOther) {
  Random random(5);
  int counts[5] = {};
  for (int i = 0; i < 5000; ++i) ++counts[random.below(5)];
  for (const int count : counts) EXPECT_NEAR(count, 1000, 150);
}

}  // namespace
}  // namespace galilean
