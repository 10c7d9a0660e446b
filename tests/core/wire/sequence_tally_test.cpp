// SPDX-License-Identifier: BSD-3-Clause
#include "core/wire/sequence_tally.h"

#include <gtest/gtest.h>

namespace galilean::wire {
namespace {

SequenceTally tally_of(std::initializer_list<std::uint64_t> sequences) {
  SequenceTally tally;
  for (const auto sequence : sequences) static_cast<void>(tally.note(sequence));
  return tally;
}

TEST(SequenceTally, LosesNothingWhereTheNumbersFollowEachOther) {
  const auto tally = tally_of({1, 2, 3});
  EXPECT_EQ(tally.received(), 3U);
  EXPECT_EQ(tally.lost(), 0U);
  EXPECT_EQ(tally.sent_before(), 0U);
}

TEST(SequenceTally, CountsWhatDidNotComeInBetween) {
  EXPECT_EQ(tally_of({1, 2, 5, 9}).lost(), 5U);
}

TEST(SequenceTally, TellsWhatWasSentBeforeSomebodyListenedFromWhatWasLost) {
  const auto tally = tally_of({41, 42, 44});
  EXPECT_EQ(tally.sent_before(), 40U);
  EXPECT_EQ(tally.lost(), 1U);
}

TEST(SequenceTally, WhatComesAgainIsTakenOnce) {
  auto tally = tally_of({1, 2, 5});
  for (const std::uint64_t again : {1, 2, 5}) EXPECT_FALSE(tally.note(again)) << again;
  EXPECT_TRUE(tally.note(6));
  EXPECT_EQ(tally.received(), 4U);
  EXPECT_EQ(tally.lost(), 2U);
}

TEST(SequenceTally, CountsMessagesWithoutANumberAndCallsNoneLost) {
  const auto tally = tally_of({0, 0, 7});
  EXPECT_EQ(tally.received(), 3U);
  EXPECT_EQ(tally.lost(), 0U);
}

TEST(SequenceTally, NothingIsLostBeforeAnythingCame) {
  EXPECT_EQ(SequenceTally().lost(), 0U);
  EXPECT_EQ(SequenceTally().sent_before(), 0U);
}

}  // namespace
}  // namespace galilean::wire
