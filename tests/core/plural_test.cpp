// SPDX-License-Identifier: BSD-3-Clause
#include "core/plural.h"

#include <gtest/gtest.h>

#include <cstddef>

namespace galilean {
namespace {

TEST(Plural, OneAloneIsSingular) {
  EXPECT_EQ(plural(std::size_t{0}, "state"), "0 states");
  EXPECT_EQ(plural(std::size_t{1}, "state"), "1 state");
  EXPECT_EQ(plural(2, "late tick"), "2 late ticks");
  EXPECT_EQ(plural(-1, "point"), "-1 points");
}

TEST(Plural, AVerbAgreesWithItsCount) {
  EXPECT_STREQ(agreeing(std::size_t{0}, " runs", " run"), " run");
  EXPECT_STREQ(agreeing(1, " runs", " run"), " runs");
  EXPECT_STREQ(agreeing(2U, " runs", " run"), " run");
}

}  // namespace
}  // namespace galilean
