// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/wire/gap_statistics.h"

#include <gtest/gtest.h>

namespace galilean::monitor {
namespace {

using std::chrono::milliseconds;

TEST(GapStatistics, OneMessageHasNoRate) {
  GapStatistics statistics;
  EXPECT_FALSE(statistics.figures());
  statistics.add(Time{milliseconds(5)}, 10);
  EXPECT_FALSE(statistics.figures());
}

TEST(GapStatistics, TellsRateGapsAndBytes) {
  GapStatistics statistics;
  for (const int at_ms : {1000, 1100, 1400, 1600}) statistics.add(Time{milliseconds(at_ms)}, 30);
  const auto figures = statistics.figures();
  ASSERT_TRUE(figures);
  EXPECT_DOUBLE_EQ(figures->rate_hz, 5);
  EXPECT_DOUBLE_EQ(figures->least_s, 0.1);
  EXPECT_DOUBLE_EQ(figures->most_s, 0.3);
  EXPECT_NEAR(figures->mean_s, 0.2, 1e-12);
  EXPECT_NEAR(figures->deviation_s, 0.0816496580927726, 1e-12);
  EXPECT_DOUBLE_EQ(figures->bytes_per_s, 150);
}

}  // namespace
}  // namespace galilean::monitor
