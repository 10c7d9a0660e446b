// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/mcap/chunk_index_log.h"

#include <gtest/gtest.h>

#include <limits>

#include "monitor/mcap/mcap_reader.h"
#include "monitor/mcap/mcap_writer.h"
#include "monitor/mcap/summary_section.h"

namespace galilean::mcap {
namespace {

constexpr std::uint64_t kLargest = std::numeric_limits<std::uint64_t>::max();

Bytes bytes_of(const ChunkIndex& index) {
  Bytes bytes;
  append(bytes, index);
  return bytes;
}

/// The index of a chunk of a second of `channels` channels, behind another.
ChunkIndex second_of(int channels, const ChunkIndex& before) {
  ChunkIndex index{.start_ns = before.start_ns + 1'000'000'007,
                   .end_ns = before.start_ns + 1'999'000'000,
                   .offset = before.offset + before.length + before.message_index_length,
                   .length = 80'000,
                   .compression = "zstd",
                   .compressed_size = 79'900,
                   .uncompressed_size = 300'000};
  std::uint64_t at = index.offset + index.length;
  for (int i = 1; i <= channels; ++i) {
    index.message_index_offsets[static_cast<std::uint16_t>(i)] = at;
    at += 15 + 16 * 10;
  }
  index.message_index_length = at - index.offset - index.length;
  return index;
}

TEST(ChunkIndexLog, GivesBackWhatWasAdded) {
  std::vector<ChunkIndex> added{second_of(3, {})};
  added.push_back(second_of(0, added.back()));
  added.push_back({.start_ns = 7, .end_ns = 3, .offset = 1, .compression = "zstd"});
  added.push_back({.start_ns = kLargest,
                   .end_ns = kLargest,
                   .offset = kLargest,
                   .length = kLargest,
                   .message_index_offsets = {{0, kLargest}, {65535, 0}},
                   .message_index_length = kLargest,
                   .compression = "zstd",
                   .compressed_size = kLargest,
                   .uncompressed_size = kLargest});
  added.push_back(second_of(400, added.front()));
  ChunkIndexLog log;
  for (const auto& each : added) log.add(each);
  ChunkIndexLog::Reader reader(log, "zstd");
  for (const auto& each : added) {
    const ChunkIndex* read = reader.next();
    ASSERT_NE(read, nullptr);
    EXPECT_EQ(bytes_of(*read), bytes_of(each));
  }
  EXPECT_EQ(reader.next(), nullptr);
  EXPECT_EQ(reader.next(), nullptr);
}

TEST(ChunkIndexLog, HasNoneAtFirst) {
  const ChunkIndexLog log;
  ChunkIndexLog::Reader reader(log, "");
  EXPECT_EQ(reader.next(), nullptr);
}

TEST(ChunkIndexLog, TakesFiveMegabytesForAnHourOfThirtyRobots) {
  ChunkIndexLog log;
  std::vector<ChunkIndex> some;
  ChunkIndex index;
  for (int second = 0; second < 3600; ++second) {
    index = second_of(400, index);
    log.add(index);
    if (second % 900 == 0) some.push_back(index);
  }
  EXPECT_LT(log.bytes(), 5'500'000u);
  ChunkIndexLog::Reader reader(log, "zstd");
  for (int second = 0; second < 3600; ++second) {
    const ChunkIndex* read = reader.next();
    ASSERT_NE(read, nullptr);
    if (second % 900 == 0) {
      EXPECT_EQ(bytes_of(*read), bytes_of(some[static_cast<std::size_t>(second) / 900]));
    }
  }
}

/// A file in memory.
class Kept final : public ByteSink {
 public:
  Result<void> write(std::span<const std::uint8_t> bytes) override {
    all.insert(all.end(), bytes.begin(), bytes.end());
    return {};
  }
  Bytes all;
};

TEST(ChunkIndexLog, MakesASummaryOfManyPiecesThatMatchesItsChecksum) {
  constexpr std::uint16_t kChannels = 200;
  constexpr std::uint64_t kSeconds = 600;  // a megabyte of indexes
  Kept file;
  Writer writer(file);
  ASSERT_TRUE(writer.begin());
  for (std::uint16_t i = 0; i < kChannels; ++i)
    ASSERT_EQ(writer.add_channel({.topic = "/t" + std::to_string(i), .message_encoding = "cdr"}),
              i + 1);
  const Bytes payload(1);
  for (std::uint64_t second = 1; second <= kSeconds; ++second)
    for (std::uint16_t i = 1; i <= kChannels; ++i)
      ASSERT_TRUE(
          writer.write(Message{i, 0, second * 1'000'000'000, second * 1'000'000'000, payload}));
  ASSERT_TRUE(writer.end());
  const auto summary = summarize(MemorySource(file.all), Depth::kIndexes);
  ASSERT_TRUE(summary);
  EXPECT_FALSE(summary.value().recovered());
  EXPECT_EQ(summary.value().statistics.messages, kChannels * kSeconds);
  EXPECT_EQ(summary.value().blocks.size(), kSeconds);
  for (const auto& chunk : read_summary_section(MemorySource(file.all)).chunks)
    EXPECT_TRUE(chunk.message_index_offsets.empty()) << "it would take fifty bytes of each channel";
}

}  // namespace
}  // namespace galilean::mcap
