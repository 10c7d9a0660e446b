// SPDX-License-Identifier: BSD-3-Clause
#include "core/variable/variable.h"

#include <gtest/gtest.h>

#include "core/variable/store.h"

namespace galilean {
namespace {

using namespace std::chrono_literals;

TEST(Variable, CertaintyDecaysToNothingInAMinuteByDefault) {
  Variable<Locate> trash;
  trash.mark_written(1, Time{10s}, 1);
  EXPECT_NEAR(trash.reliability.certainty_at(Time{10s}), 1, 1e-12);
  EXPECT_NEAR(trash.reliability.certainty_at(Time{40s}), 0.5, 1e-12);
  EXPECT_TRUE(trash.reliability.valid_at(Time{69s}));
  EXPECT_FALSE(trash.reliability.valid_at(Time{70s}));
  EXPECT_EQ(trash.reliability.certainty_at(Time{100s}), 0);
}

TEST(Variable, ResetMakesItInvalidAtOnce) {
  Variable<Bits> bits;
  bits.write({5}, 1, Time{1s}, 1);
  bits.reset(Time{1s});
  EXPECT_FALSE(bits.reliability.valid_at(Time{1s}));
  EXPECT_EQ(bits.reliability.certainty_at(Time{1s}), 0);
}

TEST(Variable, BitsAreCountedFromTheLowest) {
  Bits bits;
  bits.assign(3, true);
  EXPECT_EQ(bits.value, 8U);
  EXPECT_TRUE(bits.test(3));
  bits.assign(3, false);
  EXPECT_EQ(bits.value, 0U);
}

TEST(VariableStore, FindsByNameAndTypeAndKeepsAddresses) {
  VariableStore store;
  auto* first = &store.add<Force>("move");
  for (int i = 0; i < 100; ++i) store.add<Force>("other" + std::to_string(i));
  EXPECT_EQ(store.find<Force>("move"), first);
  EXPECT_EQ(store.find<Locate>("move"), nullptr);
  EXPECT_EQ(store.find<Force>("none"), nullptr);
}

}  // namespace
}  // namespace galilean
