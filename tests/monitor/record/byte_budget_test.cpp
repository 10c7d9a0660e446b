// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/record/byte_budget.h"

#include <gtest/gtest.h>

namespace galilean::monitor {
namespace {

/// Returns how many bytes pass in so many seconds, of which one message of `size` comes each 10 ms.
std::size_t passes(ByteBudget budget, std::size_t size, int seconds) {
  std::size_t sum = 0;
  Time now{};
  for (int i = 0; i < seconds * 100; ++i, now += std::chrono::milliseconds(10))
    if (budget.takes(size, now)) sum += size;
  return sum;
}

TEST(ByteBudget, WithoutALimitEverythingPasses) {
  EXPECT_EQ(passes(ByteBudget(0), 5000, 10), 5'000'000U);
}

TEST(ByteBudget, SoMuchPassesInTheLongRun) {
  for (const std::size_t size : {400, 1000, 5000, 30'000}) {
    const auto sum = passes(ByteBudget(20'000), size, 100);
    EXPECT_GE(sum, 100 * 20'000U - size) << size;
    EXPECT_LE(sum, 101 * 20'000U + size) << size;
  }
}

TEST(ByteBudget, WhatIsLessPassesWhole) {
  EXPECT_EQ(passes(ByteBudget(600'000), 5000, 10), 5'000'000U);
}

TEST(ByteBudget, WhatWasNotUsedIsNotSavedForLongerThanASecond) {
  ByteBudget budget(1000);
  const Time later = Time{} + std::chrono::hours(1);
  EXPECT_TRUE(budget.takes(1000, later));
  EXPECT_FALSE(budget.takes(1, later));
}

}  // namespace
}  // namespace galilean::monitor
