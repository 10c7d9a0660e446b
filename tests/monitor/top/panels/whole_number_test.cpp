// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/top/panels/whole_number.h"

#include <gtest/gtest.h>

#include <limits>

namespace galilean::monitor::top {
namespace {

TEST(WholeNumber, IsTheNearestOneWithinItsBounds) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  EXPECT_EQ(whole_number(2.6, 0, 9), 3);
  EXPECT_EQ(whole_number(-2.6, -9, 9), -3);
  EXPECT_EQ(whole_number(1e300, 0, 9), 9);
  EXPECT_EQ(whole_number(-1e300, 0, 9), 0);
  EXPECT_EQ(whole_number(kInfinity, 0, 9), 9);
  EXPECT_EQ(whole_number(-kInfinity, 0, 9), 0);
  EXPECT_EQ(whole_number(std::numeric_limits<double>::quiet_NaN(), 0, 9), 0);
}

}  // namespace
}  // namespace galilean::monitor::top
