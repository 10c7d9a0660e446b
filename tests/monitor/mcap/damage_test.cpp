// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "tests/monitor/mcap/built_file.h"

namespace galilean::mcap {
namespace {

/// Where a chunk's records begin, behind its head, if it is not compressed.
constexpr std::size_t kRecordsAt = kRecordHead + 8 + 8 + 8 + 4 + 4 + 8;

using Counts = std::map<std::uint16_t, std::uint64_t>;

/// Three chunks of which the second is to be damaged.
struct ThreeChunks {
  BuiltFile file;
  std::size_t second_at;

  explicit ThreeChunks(bool indexed = true) {
    file.channel(1).channel(2);
    file.chunk({{1, 100, 1}, {2, 110, 2}}, {.indexed = indexed});
    second_at = file.chunk({{1, 200, 3}, {1, 205, 4}, {2, 290, 5}}, {.indexed = indexed});
    file.chunk({{2, 300, 6}}, {.indexed = indexed});
  }
};

const std::vector<Small> kWithoutSecond{{1, 100, 1}, {2, 110, 2}, {2, 300, 6}};

TEST(Damage, AChunkTellsTimesAndCountsByItsMessageIndexes) {
  ThreeChunks built;
  built.file.close();
  built.file.bytes[built.second_at + kRecordsAt + 40] ^= 1;
  EXPECT_EQ(read_messages(built.file.bytes), kWithoutSecond);
  const Summary summary = summary_of(built.file.bytes);
  EXPECT_TRUE(summary.closed);
  ASSERT_EQ(summary.damages.size(), 1u);
  EXPECT_EQ(summary.damages[0].time, (TimeRange{200, 290}));
  EXPECT_EQ(summary.damages[0].messages, 3u);
  EXPECT_EQ(summary.damages[0].channel_messages, (Counts{{1, 2}, {2, 1}}));
  EXPECT_EQ(summary.lost, (Counts{{1, 2}, {2, 1}}));
  EXPECT_TRUE(summary.lost_is_exact);
  EXPECT_EQ(summary.statistics.messages, 3u);
}

TEST(Damage, WithoutIndexesTheNumberIsUnknownAndTheTimeIsTheChunksOwn) {
  ThreeChunks built(false);
  built.file.close();
  built.file.bytes[built.second_at + kRecordsAt + 40] ^= 1;
  const Summary summary = summary_of(built.file.bytes);
  ASSERT_EQ(summary.damages.size(), 1u);
  EXPECT_EQ(summary.damages[0].time, (TimeRange{200, 290}));
  EXPECT_FALSE(summary.damages[0].messages);
  EXPECT_FALSE(summary.lost_is_exact);
}

TEST(Damage, StatisticsTellWhatIndexesDoNot) {
  ThreeChunks built(false);
  built.file.close([](Bytes& summary) {
    append(summary, Statistics{.messages = 6,
                               .schemas = 2,
                               .channels = 2,
                               .chunks = 3,
                               .start_ns = 100,
                               .end_ns = 300,
                               .channel_messages = {{1, 3}, {2, 3}}});
  });
  built.file.bytes[built.second_at + kRecordsAt + 40] ^= 1;
  const Summary summary = summary_of(built.file.bytes);
  EXPECT_EQ(summary.lost, (Counts{{1, 2}, {2, 1}}));
  EXPECT_TRUE(summary.lost_is_exact);
}

TEST(Damage, AWrongLengthCostsOneChunkAndNotTheRest) {
  for (const std::uint8_t byte : {0x7f, 0x01})
    for (const std::size_t place : {1u, 2u, 3u}) {
      ThreeChunks built;
      built.file.close();
      built.file.bytes[built.second_at + place] ^= byte;
      const auto messages = read_messages(built.file.bytes);
      EXPECT_EQ(messages, kWithoutSecond) << int(byte) << " at " << place;
      EXPECT_FALSE(summary_of(built.file.bytes).damages.empty());
    }
}

TEST(Damage, ACutChunkTellsItsTimes) {
  ThreeChunks built;
  const ByteView cut = ByteView(built.file.bytes).first(built.second_at + kRecordsAt + 30);
  const Summary summary = summary_of(cut);
  EXPECT_FALSE(summary.closed);
  ASSERT_EQ(summary.damages.size(), 1u);
  EXPECT_EQ(summary.damages[0].what,
            "the chunk at byte " + std::to_string(built.second_at) + " is cut short");
  EXPECT_EQ(summary.damages[0].time, (TimeRange{200, 290}));
  EXPECT_EQ(summary.statistics.messages, 2u);
}

TEST(Damage, AChunkThatClaimsTerabytesTakesNoMemory) {
  ThreeChunks built;
  built.file.close();
  built.file.bytes[built.second_at + kRecordHead + 8 + 8 + 6] = 0x7f;  // its uncompressed size
  EXPECT_EQ(read_messages(built.file.bytes), kWithoutSecond);
  EXPECT_EQ(summary_of(built.file.bytes).damages.size(), 1u);
}

TEST(Damage, MessagesOfAChannelThatNoRecordDescribesAreNamed) {
  BuiltFile file;
  file.channel(1);
  file.chunk({{1, 100, 1}, {9, 110, 2}}, {});
  file.close();
  const Summary summary = summary_of(file.bytes);
  ASSERT_EQ(summary.damages.size(), 1u);
  EXPECT_EQ(summary.damages[0].what, "1 message of channel 9, which no record describes");
}

TEST(Damage, AMessageStampedZeroIsASilenceAndNoDamage) {
  constexpr std::uint64_t kNow_ns = 1'700'000'000'000'000'000;
  BuiltFile file;
  file.channel(1);
  file.chunk({{1, kNow_ns, 1}, {1, 0, 2}, {1, kNow_ns + 1'000'000'000, 3}}, {});
  file.close();
  const Summary summary = summary_of(file.bytes);
  EXPECT_FALSE(summary.recovered());
  ASSERT_EQ(summary.silences.size(), 1u);
  EXPECT_EQ(summary.silences[0], (TimeRange{0, kNow_ns}));
}

}  // namespace
}  // namespace galilean::mcap
