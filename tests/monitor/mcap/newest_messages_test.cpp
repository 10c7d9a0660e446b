// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/mcap/newest_messages.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <iterator>
#include <random>

#include "tests/monitor/mcap/built_file.h"

namespace galilean::mcap {
namespace {

/// Where a chunk's checksum is, behind the chunk's times and its size.
constexpr std::size_t kChecksumAt = kRecordHead + 8 + 8 + 8;

using Wanted = std::vector<NewestMessages::Wanted>;

/// Chunks of random messages whose times overlap; every fourth has no message indexes.
struct Chunks {
  BuiltFile file;
  std::vector<Small> messages;

  explicit Chunks(unsigned seed) {
    std::mt19937 random(seed);
    for (const std::uint16_t id : {1, 2, 3}) file.channel(id);
    for (int chunk = 0; chunk < 30; ++chunk) {
      std::vector<Small> some(1 + random() % 12);
      for (auto& each : some)
        each = {static_cast<std::uint16_t>(1 + random() % 3),
                1000u * static_cast<unsigned>(chunk) + random() % 3000,
                static_cast<std::uint8_t>(random())};
      messages.insert(messages.end(), some.begin(), some.end());
      file.chunk(some, {.compression = "", .indexed = chunk % 4 != 0});
    }
    file.close();
    std::ranges::stable_sort(messages, {}, &Small::log_ns);
  }
};

std::vector<Small> found_in(ByteView file, std::uint64_t before_ns, const Wanted& wanted) {
  const MemorySource source(file);
  const auto summary = summary_of(file);
  BlockChannels channels(source, summary.blocks);
  NewestMessages newest(source, summary.blocks, channels);
  std::vector<Small> small;
  for (const auto& each : newest.before(before_ns, wanted).messages)
    small.push_back({each.head.channel_id, each.head.log_ns, each.data[0]});
  return small;
}

/// The same, by looking at each message.
std::vector<Small> expected(const std::vector<Small>& messages, std::uint64_t before_ns,
                            Wanted wanted) {
  std::vector<Small> found;
  for (auto at = messages.rbegin(); at != messages.rend(); ++at)
    for (auto& [channels, most, since_ns] : wanted) {
      const bool is_one = std::ranges::find(channels, at->channel_id) != channels.end();
      if (!is_one || most == 0 || at->log_ns >= before_ns || at->log_ns < since_ns) continue;
      --most;
      found.push_back(*at);
    }
  std::ranges::reverse(found);
  return found;
}

TEST(NewestMessages, AreThoseThatASearchThroughAllMessagesFinds) {
  for (const Wanted& wanted :
       {Wanted{
            {.channels = {1}}, {.channels = {2}, .most = 5, .since_ns = 9000}, {.channels = {7}}},
        Wanted{{.channels = {1, 3}, .most = 4}, {.channels = {2}, .most = 0}}})

    for (unsigned seed = 0; seed < 30; ++seed) {
      const Chunks recording(seed);
      for (const std::uint64_t before_ns : {0u, 1u, 4000u, 12'345u, 29'000u, 100'000u})
        EXPECT_EQ(found_in(recording.file.bytes, before_ns, wanted),
                  expected(recording.messages, before_ns, wanted))
            << seed << " before " << before_ns;
    }
}

TEST(NewestMessages, DoNotNeedTheBlocksThatTheyDoNotStandIn) {
  BuiltFile file;
  file.channel(1).channel(2);
  file.chunk({{1, 1000, 1}});
  std::vector<std::size_t> chunks;
  for (std::uint64_t i = 0; i < 50; ++i) chunks.push_back(file.chunk({{2, 2000 + i, 2}}));
  file.close();
  for (const auto at : chunks) file.bytes[at + kChecksumAt] ^= 0xff;
  const MemorySource source(file.bytes);
  const auto summary = summary_of(file.bytes);
  BlockChannels channels(source, summary.blocks);
  NewestMessages newest(source, summary.blocks, channels);
  const auto found = newest.before(2050, {{.channels = {1}}});
  ASSERT_EQ(found.messages.size(), 1u);
  EXPECT_EQ(found.messages[0].data, Bytes{1});
  EXPECT_TRUE(found.damages.empty()) << "only the first chunk was read";
}

TEST(NewestMessages, TellTheDamageThatTheyMeet) {
  BuiltFile file;
  file.channel(1);
  file.chunk({{1, 1000, 1}});
  const auto at = file.chunk({{1, 2000, 2}});
  file.close();
  file.bytes[at + kChecksumAt] ^= 0xff;
  const MemorySource source(file.bytes);
  const auto summary = summary_of(file.bytes);
  BlockChannels channels(source, summary.blocks);
  NewestMessages newest(source, summary.blocks, channels);
  const auto found = newest.before(3000, {{.channels = {1}}});
  ASSERT_EQ(found.messages.size(), 1u);
  EXPECT_EQ(found.messages[0].data, Bytes{1}) << "the newest one that can be read";
  ASSERT_EQ(found.damages.size(), 1u);
  EXPECT_EQ(found.damages[0].offset, at);
}

TEST(MessageReader, BeginsAtALogTimeAndReadsTheBlocksThatAreWanted) {
  for (unsigned seed = 0; seed < 20; ++seed) {
    const Chunks recording(seed);
    const MemorySource source(recording.file.bytes);
    const auto summary = summary_of(recording.file.bytes);
    for (const std::uint64_t from_ns : {0u, 5000u, 17'001u, 40'000u}) {
      MessageReader reader(source, summary.blocks, 1, {.from_ns = from_ns});
      std::vector<Small> read, wanted;
      while (const auto* message = reader.next())
        read.push_back({message->channel_id, message->log_ns, message->data[0]});
      std::ranges::copy_if(recording.messages, std::back_inserter(wanted),
                           [&](const Small& each) { return each.log_ns >= from_ns; });
      EXPECT_EQ(read, wanted) << seed << " from " << from_ns;
    }
    MessageReader first_block(source, summary.blocks, 1,
                              {.reads = [](std::uint32_t block) { return block == 0; }});
    std::size_t count = 0;
    while (first_block.next()) ++count;
    EXPECT_GT(count, 0u);
    EXPECT_LT(count, 13u);
  }
}

}  // namespace
}  // namespace galilean::mcap
