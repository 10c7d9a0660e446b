// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <random>

#include "monitor/mcap/mcap_writer.h"
#include "tests/monitor/record/faulty_disk.h"

namespace galilean::mcap {

/// A message that owns its bytes.
struct Recorded {
  std::uint16_t channel_id;
  std::uint32_t sequence;
  std::uint64_t log_ns;
  std::uint64_t publish_ns;
  Bytes data;
  bool operator==(const Recorded&) const = default;
};

/// Writes random messages on three channels of two schemas. It keeps the messages, and the size of
/// the file after each chunk.
struct RandomRecording {
  FaultyDisk disk;
  Writer writer;
  std::vector<Recorded> messages;
  std::vector<std::size_t> messages_at_chunk;  ///< number of messages in all chunks up to this one
  std::vector<std::size_t> chunk_ends;         ///< size of the file after each chunk and its
                                               ///< indexes
  Result<void> written;

  RandomRecording(unsigned seed, int count, std::size_t capacity = SIZE_MAX)
      : disk(capacity), writer(disk, {.chunk_bytes = 2000, .chunk_span = from_seconds(0.5)}) {
    std::mt19937 random(seed);
    written = writer.begin();
    if (written) written = writer.write(Metadata{"galilean", {{"version", "1"}}});
    const auto a = writer.add_schema("a/msg/A", "ros2idl", "module a {};");
    const auto b = writer.add_schema("b/msg/B", "ros2idl", "module b {};");
    for (const auto schema : {a, b, b})
      (void)writer.add_channel({.schema_id = schema, .topic = "/t", .message_encoding = "cdr"});
    std::uint64_t now_ns = 1'000'000'000;
    for (int i = 0; i < count && written; ++i) {
      now_ns += random() % 50'000'000;
      Recorded message{static_cast<std::uint16_t>(1 + random() % 3), static_cast<std::uint32_t>(i),
                       now_ns, now_ns - random() % 1000, Bytes(random() % 300)};
      for (auto& byte : message.data) byte = static_cast<std::uint8_t>(random() % 8);
      write(message);
    }
    if (written) written = writer.end();
    note_chunk();
  }

 private:
  void write(const Recorded& message) {
    const auto chunks = writer.statistics().chunks;
    written = writer.write(
        {message.channel_id, message.sequence, message.log_ns, message.publish_ns, message.data});
    messages.push_back(message);
    if (writer.statistics().chunks != chunks) note_chunk();
  }
  void note_chunk() {
    chunk_ends.push_back(disk.bytes().size());
    messages_at_chunk.push_back(messages.size());
  }
};

}  // namespace galilean::mcap
