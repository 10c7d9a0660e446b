// SPDX-License-Identifier: BSD-3-Clause
#include "core/hexadecimal.h"

#include <gtest/gtest.h>

#include <array>

namespace galilean {
namespace {

TEST(Hexadecimal, HasTwoLowercaseDigitsForEachByte) {
  const std::array<std::uint8_t, 4> bytes{0x00, 0x0f, 0xa0, 0xff};
  EXPECT_EQ(hexadecimal(bytes), "000fa0ff");
  EXPECT_EQ(hexadecimal({}), "");
}

}  // namespace
}  // namespace galilean
