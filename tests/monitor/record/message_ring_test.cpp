// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/record/message_ring.h"

#include <gtest/gtest.h>

namespace galilean::monitor {
namespace {

class MessageRingTest : public testing::Test {
 protected:
  void add(MessageRing& ring, double s, std::size_t bytes = 10) {
    const std::vector<std::uint8_t> cdr(bytes, 7);
    const auto number = static_cast<std::uint64_t>(s * 10);
    ring.add(writer_, {cdr, 5, 1, number}, Time{} + from_seconds(s), 1000);
  }
  /// Returns the numbers of what is forgotten at that time.
  std::vector<std::uint64_t> forgotten(MessageRing& ring, double s) {
    std::vector<std::uint64_t> numbers;
    too_much_ = ring.forget(Time{} + from_seconds(s), [&](const MessageRing::Held& held) {
      numbers.push_back(held.received().sequence);
    });
    return numbers;
  }

  bool too_much_ = false;
  wire::EndpointInfo writer_{.topic = "rt/a", .guid = "g"};
};

TEST_F(MessageRingTest, KeepsTheLastSeconds) {
  MessageRing ring(from_seconds(1), 100'000);
  for (const double s : {0.1, 0.2, 0.9, 1.15}) add(ring, s);
  EXPECT_EQ(forgotten(ring, 1.15), std::vector<std::uint64_t>{1});
  EXPECT_FALSE(too_much_);
  EXPECT_EQ(ring.oldest().received().sequence, 2U);
  std::vector<std::size_t> sizes;
  ring.give([&](const MessageRing::Held& held) {
    sizes.push_back(held.received().cdr.size());
    EXPECT_EQ(held.writer->topic, "rt/a");
  });
  EXPECT_EQ(sizes, (std::vector<std::size_t>{10, 10, 10}));
  EXPECT_TRUE(ring.empty());
}

TEST_F(MessageRingTest, ForgetsWhatIsTooMuchAndSaysSo) {
  MessageRing ring(from_seconds(100), 3000);
  for (int i = 1; i <= 5; ++i) add(ring, i, 1000);
  EXPECT_EQ(forgotten(ring, 5), (std::vector<std::uint64_t>{10, 20, 30}));
  EXPECT_TRUE(too_much_);
}

}  // namespace
}  // namespace galilean::monitor
