// SPDX-License-Identifier: BSD-3-Clause
#include "core/orders/replay_window.h"

#include <gtest/gtest.h>

namespace galilean {
namespace {

TEST(ReplayWindow, TakesEachNumberOnceInAnyOrder) {
  ReplayWindow window;
  for (const std::uint64_t number : {7U, 3U, 9U, 8U, 1U}) {
    EXPECT_FALSE(window.has(number)) << number;
    window.add(number);
    EXPECT_TRUE(window.has(number)) << number;
  }
  EXPECT_FALSE(window.has(2));
  EXPECT_FALSE(window.has(10));
}

TEST(ReplayWindow, ZeroIsNoNumberOfAnOrder) {
  EXPECT_TRUE(ReplayWindow().has(0));
}

TEST(ReplayWindow, WhatIsOlderThanAllThatItKeepsCountsAsKnown) {
  ReplayWindow window;
  const std::uint64_t more = 3;
  for (std::uint64_t number = 1; number <= ReplayWindow::kKept + more; ++number)
    window.add(2 * number);
  for (std::uint64_t number = 1; number <= 2 * more; ++number)
    EXPECT_TRUE(window.has(number)) << number;
  EXPECT_FALSE(window.has(2 * more + 1));  // the oldest that is kept is two above the floor
  EXPECT_TRUE(window.has(2 * more + 2));
}

}  // namespace
}  // namespace galilean
