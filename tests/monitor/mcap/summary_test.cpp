// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "tests/monitor/mcap/built_file.h"

namespace galilean::mcap {
namespace {

/// A file with one of each kind of record in its data section.
BuiltFile one_of_each() {
  BuiltFile file;
  file.record(Metadata{"run", {{"seed", "7"}}});
  Bytes content;
  for (const std::uint64_t number : {std::uint64_t{20}, std::uint64_t{10}})
    for (int byte = 0; byte < 8; ++byte)
      content.push_back(static_cast<std::uint8_t>(number >> 8 * byte));
  for (const std::string text : {"notes.txt", "text/plain"}) {
    content.insert(content.end(), {static_cast<std::uint8_t>(text.size()), 0, 0, 0});
    content.insert(content.end(), text.begin(), text.end());
  }
  content.insert(content.end(), {2, 0, 0, 0, 0, 0, 0, 0, 'h', 'i', 0, 0, 0, 0});
  file.bytes.push_back(static_cast<std::uint8_t>(Opcode::kAttachment));
  file.bytes.push_back(static_cast<std::uint8_t>(content.size()));
  file.bytes.insert(file.bytes.end(), 7, 0);
  file.bytes.insert(file.bytes.end(), content.begin(), content.end());
  file.channel(1).loose({1, 50, 1});
  file.chunk({{1, 60, 2}, {1, 70, 3}}, {});
  return file;
}

void expect_one_of_each(const Summary& summary) {
  EXPECT_FALSE(summary.recovered());
  EXPECT_EQ(summary.header.library, "built");
  EXPECT_EQ(summary.schemas.at(1).name, "test/msg/T1");
  EXPECT_EQ(summary.channels.at(1).topic, "/t1");
  EXPECT_EQ(summary.statistics.messages, 3u);
  EXPECT_EQ(summary.statistics.channel_messages.at(1), 3u);
  EXPECT_EQ(summary.statistics.chunks, 1u);
  EXPECT_EQ(summary.statistics.start_ns, 50u);
  EXPECT_EQ(summary.statistics.end_ns, 70u);
  ASSERT_EQ(summary.metadata.size(), 1u);
  EXPECT_EQ(summary.metadata[0].entries.at("seed"), "7");
  ASSERT_EQ(summary.attachments.size(), 1u);
  EXPECT_EQ(summary.attachments[0].name, "notes.txt");
  EXPECT_EQ(summary.attachments[0].media_type, "text/plain");
  EXPECT_EQ(summary.attachments[0].data_bytes, 2u);
  EXPECT_EQ(summary.attachments[0].log_ns, 20u);
}

TEST(Summary, TheDataSectionCountsWhereThereIsNone) {
  expect_one_of_each(summary_of(one_of_each().close().bytes));
}

TEST(Summary, OneThatLacksEverythingElseIsNotBelieved) {
  auto file = one_of_each();
  file.close([](Bytes& summary) { append(summary, Statistics{}); });
  expect_one_of_each(summary_of(file.bytes));
}

TEST(Summary, MessagesThatItCountsAndThatAreNotThereAreLost) {
  auto file = one_of_each();
  file.close([](Bytes& summary) {
    append(summary, Statistics{.messages = 5, .channel_messages = {{1, 5}}});
  });
  const Summary summary = summary_of(file.bytes);
  EXPECT_TRUE(summary.recovered());
  EXPECT_EQ(summary.lost.at(1), 2u);
}

TEST(Summary, OneThatFailsItsChecksumIsDamageAndLosesNothing) {
  auto file = one_of_each();
  file.close([](Bytes& summary) { append(summary, Statistics{.messages = 3}); });
  file.bytes[file.bytes.size() - sizeof kMagic - 1] ^= 1;  // the checksum in the footer
  const Summary summary = summary_of(file.bytes);
  ASSERT_EQ(summary.damages.size(), 1u);
  EXPECT_EQ(summary.damages[0].messages, 0u);
  EXPECT_EQ(summary.statistics.messages, 3u);
  EXPECT_TRUE(summary.lost.empty());
}

}  // namespace
}  // namespace galilean::mcap
