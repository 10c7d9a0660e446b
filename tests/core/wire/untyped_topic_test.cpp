// SPDX-License-Identifier: BSD-3-Clause
#include "core/wire/untyped_topic.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "core/wire/endpoints.h"
#include "core/wire/participant.h"
#include "core/wire/reader.h"
#include "tests/core/wire/types/foreign_talk.h"
#include "tests/core/wire/wait_until.h"
#include "tests/free_domain.h"

namespace galilean::wire {
namespace {

const int kUntypedDomain = free_domain();
constexpr EndpointQos kKeepsNewest{.reliable = true,
                                   .durability = EndpointQos::Durability::kTransientLocal};

std::unique_ptr<Participant> join_as_reader() {
  return Participant::join("reader", kUntypedDomain).value();
}

std::vector<std::vector<std::uint8_t>> take_bytes(Reader& reader) {
  std::vector<std::vector<std::uint8_t>> messages;
  reader.take([&](const Received& received) {
    messages.emplace_back(received.cdr.begin(), received.cdr.end());
  });
  return messages;
}

/// Returns the first messages that come.
std::vector<std::vector<std::uint8_t>> await_bytes(Reader& reader) {
  std::vector<std::vector<std::uint8_t>> messages;
  EXPECT_TRUE(wait_until([&] { return !(messages = take_bytes(reader)).empty(); }));
  return messages;
}

TEST(UntypedTopic, GivesTheBytesThatAWriterOfThisProcessWrote) {
  const auto own = join_as_reader();
  ForeignTalk talk(own->handle(), Foreign::kKeyed, "rt/near", Cdr::kFirst);
  Reader reader(*own, {"rt/near", foreign_type(Foreign::kKeyed), true}, kKeepsNewest, 10);
  ASSERT_TRUE(talk.write());
  const std::vector<std::uint8_t> expected{0, 1, 0,   0,   42,  0,   0,   0,   6,   0,
                                           0, 0, 'w', 'h', 'e', 'e', 'l', 0,   0,   0,
                                           6, 0, 0,   0,   't', 'u', 'r', 'n', 's', 0};
  auto got = await_bytes(reader).front();
  ASSERT_GE(got.size(), expected.size());
  got[3] = 0;  // how many bytes fill up the last four
  got.resize(expected.size());
  EXPECT_EQ(got, expected);
}

TEST(UntypedTopic, PutsTogetherWhatCameInManyPackets) {
  const auto own = join_as_reader();
  const ForeignProcess foreign("talker", kUntypedDomain);
  ForeignTalk talk(foreign.participant(), Foreign::kLarge, "rt/large", Cdr::kSecond);
  ASSERT_TRUE(talk.write());
  Reader reader(*own, {"rt/large", foreign_type(Foreign::kLarge), false}, kKeepsNewest, 10);
  const auto got = await_bytes(reader).front();
  ASSERT_EQ(got.size(), 4U + 4 + 4 + 200'000);
  for (std::size_t i = 0; i < 200'000; ++i)
    ASSERT_EQ(got[12 + i], static_cast<std::uint8_t>(i * 7)) << i;
}

TEST(UntypedTopic, NumbersMessagesAsTheirWriterDoes) {
  const auto own = join_as_reader();
  const ForeignProcess foreign("talker", kUntypedDomain);
  ForeignTalk small(foreign.participant(), Foreign::kCells, "rt/numbered", Cdr::kFirst);
  ForeignTalk large(foreign.participant(), Foreign::kLarge, "rt/large", Cdr::kFirst);
  Reader reader(*own, {"rt/numbered", foreign_type(Foreign::kCells), false}, kKeepsNewest, 10);
  Reader large_reader(*own, {"rt/large", foreign_type(Foreign::kLarge), false}, kKeepsNewest, 10);
  ASSERT_TRUE(wait_until([&] { return reader.writers() == 1 && large_reader.writers() == 1; }));
  ASSERT_TRUE(wait_until([&] { return small.readers() == 1 && large.readers() == 1; }));
  std::vector<std::uint64_t> numbers;
  const auto note = [&](const Received& received) { numbers.push_back(received.sequence); };
  for (std::size_t i = 1; i <= 3; ++i) {  // one by one, because the writer keeps only the newest
    ASSERT_TRUE(small.write());
    ASSERT_TRUE(wait_until([&] { return reader.take(note), numbers.size() == i; }));
  }
  ASSERT_TRUE(large.write());
  EXPECT_TRUE(wait_until([&] { return large_reader.take(note), numbers.size() >= 4; }));
  EXPECT_EQ(numbers, (std::vector<std::uint64_t>{1, 2, 3, 1}));
}

TEST(UntypedTopic, MatchesByTheNameOfTheTypeWhateverItsDefinition) {
  const auto own = join_as_reader();
  const ForeignProcess foreign("talker", kUntypedDomain);
  ForeignTalk talk(foreign.participant(), Foreign::kRobotState, "rt/io/state", Cdr::kFirst);
  const Reader other(*own, {"rt/io/state", "other::Type", false}, kKeepsNewest, 10);
  Reader reader(*own, {"rt/io/state", foreign_type(Foreign::kRobotState), false}, kKeepsNewest, 10);
  ASSERT_TRUE(talk.write());
  EXPECT_EQ(await_bytes(reader).size(), 1U);
  EXPECT_EQ(other.writers(), 0);
}

TEST(UntypedTopic, HearsAWriterThatIsInNoHurry) {
  const auto own = join_as_reader();
  const ForeignProcess foreign("talker", kUntypedDomain);
  ForeignTalk talk(foreign.participant(), Foreign::kPlain, "rt/calm", Cdr::kFirst, "",
                   Delivery::kState, std::chrono::seconds(1));
  Reader reader(*own, {"rt/calm", foreign_type(Foreign::kPlain), false}, kKeepsNewest, 10);
  EXPECT_TRUE(wait_until([&] { return reader.writers() == 1 && talk.readers() == 1; }));
}

TEST(UntypedTopic, ReadsEveryPartition) {
  const auto own = join_as_reader();
  const ForeignProcess foreign("talker", kUntypedDomain);
  ForeignTalk talk(foreign.participant(), Foreign::kPlain, "rt/lab", Cdr::kFirst, "lab");
  Reader reader(*own, {"rt/lab", foreign_type(Foreign::kPlain), false}, kKeepsNewest, 10);
  ASSERT_TRUE(talk.write());
  EXPECT_EQ(await_bytes(reader).size(), 1U);
}

TEST(UntypedTopic, TakesKeysThatAreNoMoreForNoMessages) {
  const auto own = join_as_reader();
  const ForeignProcess foreign("talker", kUntypedDomain);
  ForeignTalk talk(foreign.participant(), Foreign::kKeyed, "rt/keyed", Cdr::kSecond);
  Reader reader(*own, {"rt/keyed", foreign_type(Foreign::kKeyed), true}, kKeepsNewest, 10);
  ASSERT_TRUE(talk.write());
  EXPECT_EQ(await_bytes(reader).size(), 1U);
  ASSERT_TRUE(talk.dispose());
  ASSERT_TRUE(talk.write());
  EXPECT_EQ(await_bytes(reader).size(), 1U);
}

TEST(UntypedTopic, ANameThatDdsRefusesIsToldOf) {
  const auto own = join_as_reader();
  try {
    const Entity topic = make_untyped_topic(*own, {"not a name", "foreign::Plain", false});
    FAIL();
  } catch (const std::runtime_error& error) {
    EXPECT_NE(std::string(error.what()).find("not a name"), std::string::npos);
  }
}

}  // namespace
}  // namespace galilean::wire
