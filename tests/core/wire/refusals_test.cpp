// SPDX-License-Identifier: BSD-3-Clause
#include "core/wire/refusals.h"

#include <gtest/gtest.h>

namespace galilean::wire {
namespace {

TEST(Refusals, CountEachAndTellTheFirstOfAKind) {
  Refusals refusals;
  std::vector<std::string> told;
  refusals.tell_with([&](const std::string& sentence) { told.push_back(sentence); });
  refusals.note("rt/io/state", "RobotState.x_m is not from -1e6 to 1e6");
  refusals.note("rt/io/state", "RobotState.x_m is not from -1e6 to 1e6");
  refusals.note("rt/io/state", "it is cut short");
  const auto counts = refusals.counts();
  ASSERT_EQ(counts.size(), 2U);
  EXPECT_EQ(counts[0].topic, "rt/io/state");
  EXPECT_EQ(counts[0].reason, "RobotState.x_m is not from -1e6 to 1e6");
  EXPECT_EQ(counts[0].messages, 2U);
  ASSERT_EQ(told.size(), 2U);
  EXPECT_EQ(told[0],
            "a message on rt/io/state was ignored: RobotState.x_m is not from -1e6 to 1e6 (more of "
            "this kind are only counted)");
}

TEST(Refusals, TellApartOnlySoManyKinds) {
  Refusals refusals;
  std::size_t told = 0;
  refusals.tell_with([&](const std::string&) { ++told; });
  constexpr std::size_t kTopics = 10'000;
  for (std::size_t i = 0; i < kTopics; ++i)
    refusals.note("rt/invented_" + std::to_string(i) + "/state", "it is cut short");
  const auto counts = refusals.counts();
  EXPECT_EQ(counts.size(), Refusals::kMostKinds + 1);
  EXPECT_EQ(told, Refusals::kMostKinds);
  EXPECT_EQ(counts.front().topic, Refusals::kOthers);
  EXPECT_EQ(counts.front().messages, kTopics - Refusals::kMostKinds);
}

TEST(Refusals, ShowWhatATopicsNameHides) {
  Refusals refusals;
  std::string told;
  refusals.tell_with([&](const std::string& sentence) { told = sentence; });
  refusals.note("rt/\x1b[2J", "it is cut short");
  EXPECT_EQ(told.find('\x1b'), std::string::npos);
}

}  // namespace
}  // namespace galilean::wire
