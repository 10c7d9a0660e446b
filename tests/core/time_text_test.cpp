// SPDX-License-Identifier: BSD-3-Clause
#include "core/time_text.h"

#include <gmock/gmock.h>

#include <limits>

namespace galilean {
namespace {

TEST(TimeText, IsOfTheWorldsTime) {
  EXPECT_EQ(utc_text(0), "1970-01-01T00:00:00Z");
  EXPECT_EQ(utc_text(1'772'366'400), "2026-03-01T12:00:00Z");
}

TEST(TimeText, ATimeThatNoCalendarHasIsItsSeconds) {
  EXPECT_EQ(utc_text(std::numeric_limits<std::int64_t>::max()), "9223372036854775807");
}

TEST(TimeText, IsOfTheClockOfThisMachine) {
  EXPECT_THAT(local_time(1'772'366'400'000'000'000),
              testing::MatchesRegex("2026-0[23]-[0-9][0-9] [0-9][0-9]:[0-9][0-9]:00"));
}

}  // namespace
}  // namespace galilean
