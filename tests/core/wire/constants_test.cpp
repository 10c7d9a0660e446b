// SPDX-License-Identifier: BSD-3-Clause
#include "core/wire/constants.h"

#include <gtest/gtest.h>

#include "core/wire/messages.h"

namespace galilean::msg {
namespace {

namespace points = BreakPoint_Constants;

TEST(Constants, AreKnownByTheirNamesAndTheirValues) {
  EXPECT_EQ(value_of(points::kAll, "stop_team"), points::STOP_TEAM);
  EXPECT_EQ(value_of(points::kAll, "STOP_TEAM"), std::nullopt);
  EXPECT_EQ(value_of(points::kAll, ""), std::nullopt);
  for (const auto& [name, value] : points::kAll) EXPECT_EQ(name_of(points::kAll, value), name);
}

TEST(Constants, AValueOfALaterReleaseIsToldAsANumber) {
  EXPECT_EQ(name_of(points::kAll, 200), "200");
  EXPECT_EQ(name_of(points::kAll, 0), "0");
}

TEST(Constants, AreListedAsAChoice) {
  EXPECT_EQ(choice_of(points::kAll), "stop, stop_team or lock");
  EXPECT_EQ(choice_of({}), "");
}

}  // namespace
}  // namespace galilean::msg
