// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>

#include "monitor/mcap/crc32.h"
#include "monitor/mcap/mcap_reader.h"
#include "monitor/mcap/message_reader.h"
#include "tests/monitor/record/random_recording.h"
#include "tests/temporary_folder.h"

namespace galilean::mcap {
namespace {

Summary summary_of(ByteView file) {
  auto summary = summarize(MemorySource(file));
  if (!summary) throw std::runtime_error(summary.error().message);
  return std::move(summary).value();
}

std::vector<Recorded> read_all(ByteView file, const Summary& summary) {
  const MemorySource source(file);
  MessageReader reader(source, summary.blocks);
  std::vector<Recorded> messages;
  while (const Message* m = reader.next())
    messages.push_back({m->channel_id, m->sequence, m->log_ns, m->publish_ns,
                        Bytes(m->data.begin(), m->data.end())});
  return messages;
}

std::vector<Recorded> read_all(ByteView file) {
  return read_all(file, summary_of(file));
}

TEST(Crc32, IsThatOfZlib) {
  const std::string text = "123456789";
  const ByteView bytes(reinterpret_cast<const std::uint8_t*>(text.data()), text.size());
  EXPECT_EQ(crc32(bytes), 0xcbf43926u);
  EXPECT_EQ(crc32(bytes.subspan(4), crc32(bytes.first(4))), 0xcbf43926u);
  EXPECT_EQ(crc32({}), 0u);
}

TEST(Mcap, GivesBackWhatWasWritten) {
  for (unsigned seed = 0; seed < 20; ++seed) {
    const RandomRecording recording(seed, 200);
    ASSERT_TRUE(recording.written);
    EXPECT_EQ(read_all(recording.disk.bytes()), recording.messages);
    EXPECT_FALSE(summary_of(recording.disk.bytes()).recovered());
  }
}

TEST(Mcap, SummarizesWhatWasWritten) {
  const RandomRecording recording(1, 300);
  const auto& file = recording.disk.bytes();
  const Summary summary = summary_of(file);
  EXPECT_FALSE(summary.recovered());
  EXPECT_EQ(summary.header.profile, "ros2");
  EXPECT_EQ(summary.schemas.size(), 2u);
  EXPECT_EQ(summary.channels.at(3).schema_id, 2);
  EXPECT_EQ(summary.statistics.messages, 300u);
  EXPECT_EQ(summary.statistics.start_ns, recording.messages.front().log_ns);
  EXPECT_EQ(summary.statistics.end_ns, recording.messages.back().log_ns);
  EXPECT_EQ(summary.compressions.at("zstd"), summary.statistics.chunks);
  EXPECT_GT(summary.statistics.chunks, 5u);
  EXPECT_EQ(summary.metadata.at(0).entries.at("version"), "1");
}

TEST(Mcap, AnEmptyRecordingIsWhole) {
  const RandomRecording recording(1, 0);
  const Summary summary = summary_of(recording.disk.bytes());
  EXPECT_FALSE(summary.recovered());
  EXPECT_EQ(summary.statistics.messages, 0u);
}

const Bytes kAttachedText{'h', 'i'};

Bytes recording_with_an_attachment() {
  FaultyDisk disk;
  Writer writer(disk);
  EXPECT_TRUE(writer.begin());
  EXPECT_TRUE(writer.write(Attachment{.log_ns = 7,
                                      .create_ns = 5,
                                      .name = "3f2a/talk.bhdl",
                                      .media_type = "text/plain",
                                      .data_bytes = kAttachedText.size()},
                           MemorySource(kAttachedText)));
  EXPECT_TRUE(writer.end());
  return disk.bytes();
}

TEST(Mcap, GivesBackWhatWasAttached) {
  const Bytes file = recording_with_an_attachment();
  const Summary summary = summary_of(file);
  EXPECT_FALSE(summary.recovered());
  EXPECT_EQ(summary.statistics.attachments, 1u);
  ASSERT_EQ(summary.attachments.size(), 1u);
  const auto& attachment = summary.attachments[0];
  EXPECT_EQ(attachment.name, "3f2a/talk.bhdl");
  EXPECT_EQ(attachment.log_ns, 7u);
  EXPECT_EQ(attachment.create_ns, 5u);
  EXPECT_EQ(attachment.media_type, "text/plain");
  Bytes data(attachment.data_bytes);
  ASSERT_TRUE(MemorySource(file).read(attachment.data_offset, data));
  EXPECT_EQ(data, kAttachedText);
  EXPECT_EQ(summary_of(ByteView(file).first(file.size() - 1)).attachments.size(), 1u);
}

TEST(Mcap, AnAttachmentThatChangedIsReported) {
  Bytes file = recording_with_an_attachment();
  const auto at = std::search(file.begin(), file.end(), kAttachedText.begin(), kAttachedText.end());
  ASSERT_NE(at, file.end());
  *at ^= 1;
  EXPECT_EQ(summary_of(file).damages.size(), 1u);
}

TEST(Mcap, ChunksCloseByTimeToo) {
  FaultyDisk disk;
  Writer writer(disk);
  ASSERT_TRUE(writer.begin());
  const auto channel = writer.add_channel({.topic = "/t", .message_encoding = "cdr"});
  const Bytes data{1, 2, 3};
  ASSERT_TRUE(writer.write(Message{channel, 1, 5'000'000'000, 5'000'000'000, data}));
  ASSERT_TRUE(writer.close_chunk_if_due(5'999'999'999));
  EXPECT_EQ(writer.statistics().chunks, 0u);
  ASSERT_TRUE(writer.close_chunk_if_due(6'000'000'000));
  EXPECT_EQ(writer.statistics().chunks, 1u);
  EXPECT_EQ(read_all(disk.bytes()).size(), 1u);
}

/// Messages in chunks that had wholly reached the disk when it held `size` bytes.
std::size_t whole_messages(const RandomRecording& recording, const std::vector<Recorded>& got) {
  return std::min(got.size(), recording.messages.size());
}

TEST(Mcap, AFileCutAnywhereGivesAllItsWholeChunks) {
  const RandomRecording recording(7, 50);
  const ByteView file = recording.disk.bytes();
  std::size_t least = 0;
  for (std::size_t size = sizeof kMagic; size < file.size(); ++size) {
    const Summary summary = summary_of(file.first(size));
    const auto got = read_all(file.first(size), summary);
    for (std::size_t chunk = 0; chunk + 1 < recording.chunk_ends.size(); ++chunk)
      if (recording.chunk_ends[chunk] <= size) least = recording.messages_at_chunk[chunk];
    ASSERT_GE(got.size() + 1, least) << "cut at byte " << size;
    const std::vector before(
        recording.messages.begin(),
        recording.messages.begin() + static_cast<std::ptrdiff_t>(whole_messages(recording, got)));
    ASSERT_EQ(got, before) << "cut at byte " << size;
    EXPECT_TRUE(summary.recovered());
    EXPECT_EQ(summary.statistics.messages, got.size());
  }
}

TEST(Mcap, AFullDiskLeavesWhatWasWrittenReadable) {
  const std::size_t whole = RandomRecording(7, 120).disk.bytes().size();
  for (std::size_t capacity = sizeof kMagic; capacity < whole; capacity += 13) {
    const RandomRecording recording(7, 120, capacity);
    ASSERT_FALSE(recording.written);
    EXPECT_EQ(recording.written.error().message, "the disk is full");
    const auto got = read_all(recording.disk.bytes());
    EXPECT_EQ(got,
              std::vector(recording.messages.begin(),
                          recording.messages.begin() + static_cast<std::ptrdiff_t>(got.size())));
  }
}

/// What `recording` holds, but for the chunk of that number.
std::vector<Recorded> without_chunk(const RandomRecording& recording, std::size_t chunk) {
  const auto messages_until = [&](std::size_t last) {
    const ByteView whole = recording.disk.bytes();
    return static_cast<std::ptrdiff_t>(read_all(whole.first(recording.chunk_ends[last])).size());
  };
  auto rest = recording.messages;
  rest.erase(rest.begin() + messages_until(chunk - 1), rest.begin() + messages_until(chunk));
  return rest;
}

TEST(Mcap, DamageIsFoundNamedAndLeftOut) {
  const RandomRecording recording(3, 120);
  const Bytes& file = recording.disk.bytes();
  constexpr std::size_t kPayloadAt = kRecordHead + 4 * 8 + 4;
  ASSERT_GT(recording.chunk_ends.size(), 4u);
  for (std::size_t chunk = 1; chunk + 2 < recording.chunk_ends.size(); ++chunk) {
    const std::size_t chunk_at = recording.chunk_ends[chunk - 1];
    ASSERT_EQ(file[chunk_at], static_cast<std::uint8_t>(Opcode::kChunk));
    Bytes damaged = file;
    damaged[chunk_at + kPayloadAt + 100] ^= 1;
    const auto rest = without_chunk(recording, chunk);
    EXPECT_LT(rest.size(), recording.messages.size());
    EXPECT_TRUE(read_all(damaged) == rest) << chunk;
    const Summary summary = summary_of(damaged);
    EXPECT_TRUE(summary.closed);
    ASSERT_EQ(summary.damages.size(), 1u) << chunk;
    EXPECT_EQ(summary.damages[0].offset, chunk_at);
    EXPECT_EQ(summary.damages[0].messages, recording.messages.size() - rest.size());
  }
}

TEST(Mcap, DamageAnywhereYieldsOnlyWhatWasWrittenAndIsTold) {
  const RandomRecording recording(3, 120);
  const Bytes& file = recording.disk.bytes();
  std::mt19937 random(1);
  std::size_t read = 0, damaged_files = 0, silent = 0;
  for (int round = 0; round < 3000; ++round) {
    Bytes damaged = file;
    for (int i = 0; i < 1 + round % 5; ++i)
      damaged[sizeof kMagic + random() % (damaged.size() - sizeof kMagic)] =
          static_cast<std::uint8_t>(random());
    const Summary summary = summary_of(damaged);
    const auto messages = read_all(damaged, summary);
    for (const auto& message : messages)
      EXPECT_NE(std::find(recording.messages.begin(), recording.messages.end(), message),
                recording.messages.end());
    if (messages != recording.messages) {
      ++damaged_files;
      if (!summary.recovered()) ++silent;
    }
    read += messages.size();
  }
  EXPECT_GT(damaged_files, 1000u);
  EXPECT_EQ(silent, 0u);
  EXPECT_GT(read, 3000 * recording.messages.size() / 4);
}

std::uint64_t number_at(const Bytes& file, std::size_t at, int bytes) {
  std::uint64_t number = 0;
  for (int i = bytes; i-- > 0;) number = number << 8 | file[at + static_cast<std::size_t>(i)];
  return number;
}

TEST(Mcap, ItsChecksumsAreThoseOfTheDataAndOfTheSummary) {
  const RandomRecording recording(3, 120);
  const Bytes& file = recording.disk.bytes();
  const std::size_t footer_at = file.size() - sizeof kMagic - kRecordHead - 20;
  ASSERT_EQ(file[footer_at], static_cast<std::uint8_t>(Opcode::kFooter));
  const std::size_t summary_at = number_at(file, footer_at + kRecordHead, 8);
  const std::size_t crc_at = footer_at + kRecordHead + 16;
  EXPECT_EQ(number_at(file, crc_at, 4),
            crc32(ByteView(file).subspan(summary_at, crc_at - summary_at)));
  const std::size_t data_end_at = summary_at - kRecordHead - 4;
  ASSERT_EQ(file[data_end_at], static_cast<std::uint8_t>(Opcode::kDataEnd));
  EXPECT_EQ(number_at(file, data_end_at + kRecordHead, 4),
            crc32(ByteView(file).first(data_end_at)));
}

TEST(Mcap, AChunkThatFailsItsChecksumIsReported) {
  const RandomRecording recording(3, 120);
  Bytes file = recording.disk.bytes();
  std::size_t chunk_at = 0;
  ASSERT_GT(recording.chunk_ends.size(), 3u);
  for (std::size_t at = recording.chunk_ends[0]; at < file.size(); ++at)
    if (file[at] == static_cast<std::uint8_t>(Opcode::kChunk)) {
      chunk_at = at;
      break;
    }
  constexpr std::size_t kCrcAt = kRecordHead + 8 + 8 + 8;
  file[chunk_at + kCrcAt] ^= 0xff;
  const auto got = read_all(file);
  EXPECT_LT(got.size(), recording.messages.size());
  EXPECT_EQ(got.back(), recording.messages.back());
  const Summary summary = summary_of(file);
  ASSERT_EQ(summary.damages.size(), 1u);
  EXPECT_EQ(summary.damages[0].what,
            "the chunk at byte " + std::to_string(chunk_at) + " does not match its checksum");
}

TEST(Mcap, WhatIsNoMcapFileIsSaidToBeNone) {
  const Bytes other{'P', 'K', 3, 4, 0, 0, 0, 0, 0, 0};
  const auto summary = summarize(MemorySource(other));
  ASSERT_FALSE(summary.ok());
  EXPECT_EQ(summary.error().message, "is not an MCAP file");
  EXPECT_FALSE(summarize(MemorySource({})).ok());
}

TEST(FileSink, TellsThatTheDiskIsFull) {
  auto file = FileSink::create("/dev/full", true);
  ASSERT_TRUE(file.ok());
  const Bytes bytes(100);
  const auto written = file.value().write(bytes);
  ASSERT_FALSE(written);
  EXPECT_EQ(written.error().message, "/dev/full cannot be written: No space left on device");
}

TEST(FileSink, DoesNotReplaceARecordingUnasked) {
  const TemporaryFolder folder;
  const std::string path = folder / "recording.mcap";
  { ASSERT_TRUE(FileSink::create(path, true).ok()); }
  const auto again = FileSink::create(path, false);
  ASSERT_FALSE(again.ok());
  EXPECT_NE(again.error().message.find("exists already"), std::string::npos);
}

}  // namespace
}  // namespace galilean::mcap
