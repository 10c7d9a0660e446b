// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/access/guess_limit.h"

#include <gtest/gtest.h>

namespace galilean::monitor {
namespace {

constexpr Duration kNoWait{};

class GuessLimitTest : public testing::Test {
 protected:
  GuessLimit::Verdict guess(const std::string& address, const std::string& digest) {
    return limit.note_wrong(address, digest, clock.now());
  }
  Duration wait(const std::string& address, const std::string& digest) {
    return guess(address, digest).wait;
  }
  void use_up(const std::string& address) {
    for (std::size_t i = 0; i < GuessLimit::kMostGuesses; ++i)
      EXPECT_EQ(wait(address, std::to_string(i)), kNoWait);
  }

  SteppedClock clock;
  GuessLimit limit;
};

TEST_F(GuessLimitTest, WhoTriesManyTokensWaitsUntilTheMinuteIsOver) {
  use_up("192.0.2.1");
  clock.advance(std::chrono::seconds(20));
  const auto refused = guess("192.0.2.1", "new");
  EXPECT_EQ(refused.wait, std::chrono::seconds(40));
  EXPECT_TRUE(refused.is_first);
  EXPECT_FALSE(guess("192.0.2.1", "newer").is_first);
  clock.advance(std::chrono::seconds(40));
  EXPECT_EQ(wait("192.0.2.1", "new"), kNoWait);
}

TEST_F(GuessLimitTest, OtherAddressesDoNotWaitForIt) {
  use_up("192.0.2.1");
  EXPECT_GT(wait("192.0.2.1", "new"), kNoWait);
  EXPECT_EQ(wait("192.0.2.2", "new"), kNoWait);
}

TEST_F(GuessLimitTest, AnOldPageThatSendsOneTokenAgainIsNoGuesserButIsBounded) {
  for (std::size_t i = 0; i < GuessLimit::kMostRequests; ++i)
    ASSERT_EQ(wait("192.0.2.1", "old"), kNoWait) << i;
  EXPECT_GT(wait("192.0.2.1", "old"), kNoWait);
  use_up("192.0.2.2");
  EXPECT_EQ(wait("192.0.2.2", "0"), kNoWait) << "that one is known";
}

TEST_F(GuessLimitTest, AMachineDoesNotBecomeAnotherByAnotherAddressOfItsNetwork) {
  for (std::size_t i = 0; i < GuessLimit::kMostGuesses; ++i)
    EXPECT_EQ(wait("2001:db8::" + std::to_string(i + 1), std::to_string(i)), kNoWait);
  EXPECT_GT(wait("2001:db8::ffff:1", "new"), kNoWait);
  EXPECT_EQ(wait("2001:db8:0:1::1", "new"), kNoWait);
  EXPECT_EQ(network_of("::ffff:192.0.2.1"), "192.0.2.1");
  EXPECT_EQ(network_of("fe80::1%eth0"), "fe80::");
  EXPECT_EQ(network_of("192.0.2.1"), "192.0.2.1");
  EXPECT_EQ(network_of(""), "");
}

TEST_F(GuessLimitTest, ManyAddressesShareACountAndMakeRoomWhenTheirMinuteIsOver) {
  const auto address = [](std::size_t i) {
    return "10." + std::to_string(i / 65536) + "." + std::to_string(i / 256 % 256) + "." +
           std::to_string(i % 256);
  };
  for (std::size_t i = 0; i < GuessLimit::kMostAddresses; ++i)
    ASSERT_EQ(wait(address(i), "guess"), kNoWait);
  for (std::size_t i = 0; i < GuessLimit::kMostGuesses; ++i)
    ASSERT_EQ(wait(address(GuessLimit::kMostAddresses + i), std::to_string(i)), kNoWait);
  EXPECT_GT(wait("192.0.2.1", "new"), kNoWait);
  EXPECT_EQ(wait(address(0), "another guess"), kNoWait) << "it has a count of its own";
  clock.advance(GuessLimit::kWindow);
  EXPECT_EQ(wait("192.0.2.1", "new"), kNoWait);
}

}  // namespace
}  // namespace galilean::monitor
