// SPDX-License-Identifier: BSD-3-Clause
#include "core/command_line/seconds_of.h"

#include <gtest/gtest.h>

namespace galilean {
namespace {

TEST(SecondsOf, ReadsEveryUnit) {
  EXPECT_EQ(seconds_of("10").value(), 10);
  EXPECT_EQ(seconds_of("10s").value(), 10);
  EXPECT_EQ(seconds_of("250ms").value(), 0.25);
  EXPECT_EQ(seconds_of("1.5min").value(), 90);
  EXPECT_EQ(seconds_of("2h").value(), 7200);
  EXPECT_EQ(seconds_of("0").value(), 0);
}

TEST(SecondsOf, RefusesWhatIsNoTime) {
  for (const char* text : {"", "s", "-1s", "nan", "inf", "1e999", "10 s", "10x", "1s2", "ten"})
    EXPECT_FALSE(seconds_of(text).ok()) << text;
  EXPECT_EQ(seconds_of("10\x1b").error().message, "'10U+001B' is not a valid time, such as 10s");
}

}  // namespace
}  // namespace galilean
