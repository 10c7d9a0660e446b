// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/ingest/kept_bytes.h"

#include <gtest/gtest.h>

#include <limits>

namespace galilean::monitor {
namespace {

using wire::Delivery;
constexpr std::size_t kQuarter = KeptBytes::kMost / 4;

TEST(KeptBytesTest, AStateReplacesTheOneBefore) {
  KeptBytes kept;
  std::size_t topic = 0;
  for (int i = 0; i < 10; ++i) EXPECT_TRUE(kept.take(topic, Delivery::kState, 3 * kQuarter));
  EXPECT_EQ(kept.all(), 3 * kQuarter);
  EXPECT_TRUE(kept.take(topic, Delivery::kState, 100));
  EXPECT_EQ(kept.all(), 0U);
}

TEST(KeptBytesTest, BeyondTheMostOnlyShortOnesAreTaken) {
  KeptBytes kept;
  std::size_t topics[5] = {};
  for (std::size_t i = 0; i < 4; ++i) EXPECT_TRUE(kept.take(topics[i], Delivery::kState, kQuarter));
  EXPECT_FALSE(kept.take(topics[4], Delivery::kState, kQuarter));
  EXPECT_EQ(topics[4], 0U);
  EXPECT_TRUE(kept.take(topics[4], Delivery::kState, KeptBytes::kFree));
  EXPECT_TRUE(kept.take(topics[0], Delivery::kState, kQuarter)) << "it has its place";
  EXPECT_EQ(kept.all(), KeptBytes::kMost);
}

TEST(KeptBytesTest, OfEventsAllThatAreKeptCount) {
  KeptBytes kept;
  std::size_t topic = 0;
  const std::size_t times = wire::kept_for_late_joiners(Delivery::kEvent);
  EXPECT_TRUE(kept.take(topic, Delivery::kEvent, kQuarter / times));
  EXPECT_TRUE(kept.take(topic, Delivery::kEvent, 1));
  EXPECT_EQ(topic, kQuarter / times * times) << "the long one is still kept";
  EXPECT_FALSE(kept.take(topic, Delivery::kEvent, KeptBytes::kMost / times + 1));
}

TEST(KeptBytesTest, NoLengthIsTooLongToReckonWith) {
  KeptBytes kept;
  std::size_t topic = 0;
  EXPECT_FALSE(kept.take(topic, Delivery::kEvent, std::numeric_limits<std::size_t>::max()));
  EXPECT_FALSE(kept.take(topic, Delivery::kState, std::numeric_limits<std::size_t>::max()));
  EXPECT_EQ(kept.all(), 0U);
}

}  // namespace
}  // namespace galilean::monitor
