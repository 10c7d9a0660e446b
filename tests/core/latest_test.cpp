// SPDX-License-Identifier: BSD-3-Clause
#include "core/latest.h"

#include <gtest/gtest.h>

#include <thread>

namespace galilean {
namespace {

TEST(Latest, GivesTheNewestAndOnlyOnce) {
  Latest<int> latest;
  EXPECT_FALSE(latest.take());
  latest.publish(1);
  latest.publish(2);
  EXPECT_TRUE(latest.take());
  EXPECT_EQ(latest.reading(), 2);
  EXPECT_FALSE(latest.take());
  EXPECT_EQ(latest.reading(), 2);
}

// Under ThreadSanitizer this is the proof that neither side sees the other's half-written place.
TEST(Latest, NeverTearsBetweenTwoThreads) {
  struct Pair {
    long a = 0;
    long b = 0;
  };
  Latest<Pair> latest;
  constexpr long kLast = 200000;
  std::thread writer([&] {
    for (long i = 1; i <= kLast; ++i) latest.publish({i, -i});
  });
  long seen = 0;
  while (seen < kLast) {
    if (!latest.take()) continue;
    ASSERT_EQ(latest.reading().a, -latest.reading().b);
    ASSERT_GT(latest.reading().a, seen);
    seen = latest.reading().a;
  }
  writer.join();
}

}  // namespace
}  // namespace galilean
