// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/mcap/outline.h"

#include <gtest/gtest.h>

#include "monitor/mcap/mcap_writer.h"
#include "tests/monitor/mcap/built_file.h"
#include "tests/monitor/record/faulty_disk.h"

namespace galilean::mcap {
namespace {

/// Hundred messages on two channels, of which the second turns up in the middle.
Bytes recorded() {
  FaultyDisk disk;
  Writer writer(disk, {.chunk_bytes = 300});
  EXPECT_TRUE(writer.begin());
  const auto schema = writer.add_schema("a/msg/A", "ros2msg", "int32 a");
  (void)writer.add_channel({.schema_id = schema, .topic = "/one", .message_encoding = "cdr"});
  for (std::uint8_t i = 0; i < 100; ++i) {
    if (i == 50)
      (void)writer.add_channel({.schema_id = schema, .topic = "/two", .message_encoding = "cdr"});
    const std::uint64_t log_ns = 1000 + i;
    const std::uint16_t channel = i < 50 ? 1 : 1 + i % 2;
    EXPECT_TRUE(writer.write(Message{channel, i, log_ns, log_ns, {&i, 1}}));
  }
  EXPECT_TRUE(writer.end());
  return disk.bytes();
}

TEST(Outline, TakesAWholeFilesWordAndReadsNoMessage) {
  auto file = recorded();
  const auto whole = outline(MemorySource(file));
  ASSERT_TRUE(whole);
  EXPECT_EQ(whole.value().messages, 100u);
  EXPECT_EQ(whole.value().start_ns, 1000u);
  EXPECT_EQ(whole.value().end_ns, 1099u);
  EXPECT_EQ(whole.value().channels.size(), 2u);
  EXPECT_TRUE(whole.value().closed);
  EXPECT_FALSE(whole.value().damaged);
  const auto blocks = summary_of(file).blocks;
  for (std::uint64_t i = 40; i < blocks[1].bytes; ++i) file[blocks[1].offset + i] ^= 0xff;
  EXPECT_EQ(outline(MemorySource(file)).value().messages, 100u) << "a glance sees no damage";
}

TEST(Outline, CountsByTheIndexesOfAFileThatBrokeOff) {
  const auto file = recorded();
  const auto blocks = summary_of(file).blocks;
  const auto& last = blocks.at(blocks.size() - 2);
  const auto cut = static_cast<std::size_t>(last.index_offset + last.index_bytes);
  const auto part = ByteView(file).first(cut);
  const auto found = outline(MemorySource(part));
  ASSERT_TRUE(found);
  EXPECT_FALSE(found.value().closed);
  EXPECT_EQ(found.value().messages, summary_of(part).statistics.messages);
  EXPECT_EQ(found.value().end_ns, last.end_ns);
  EXPECT_EQ(found.value().channels.size(), 2u) << "the second is described in a later chunk";
}

TEST(Outline, SaysWhatIsNoRecording) {
  EXPECT_EQ(outline(MemorySource({})).error().message, "is empty: nothing was recorded");
  const Bytes text{'n', 'o', ' ', 'r', 'e', 'c', 'o', 'r', 'd', 'i', 'n', 'g'};
  EXPECT_EQ(outline(MemorySource(text)).error().message, "is not an MCAP file");
}

TEST(IndexDepth, FindsWhatReadingAllMessagesFinds) {
  const auto file = recorded();
  BuiltFile unindexed;
  unindexed.channel(1);
  unindexed.chunk({{1, 5, 1}, {1, 7, 2}}, {.compression = "zstd", .indexed = false});
  unindexed.chunk({{1, 9, 3}});
  for (const auto& bytes : {file, unindexed.bytes}) {
    const MemorySource source(bytes);
    const auto all = summarize(source, Depth::kAll), some = summarize(source, Depth::kIndexes);
    ASSERT_TRUE(all && some);
    EXPECT_EQ(some.value().statistics.messages, all.value().statistics.messages);
    EXPECT_EQ(some.value().statistics.channel_messages, all.value().statistics.channel_messages);
    EXPECT_EQ(some.value().statistics.start_ns, all.value().statistics.start_ns);
    EXPECT_EQ(some.value().statistics.end_ns, all.value().statistics.end_ns);
    EXPECT_EQ(some.value().channels.size(), all.value().channels.size());
  }
}

}  // namespace
}  // namespace galilean::mcap
