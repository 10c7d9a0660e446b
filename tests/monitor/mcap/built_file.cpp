// SPDX-License-Identifier: BSD-3-Clause
#include "tests/monitor/mcap/built_file.h"

#include <lz4frame.h>

#include <algorithm>
#include <stdexcept>

#include "monitor/mcap/crc32.h"
#include "monitor/mcap/zstd.h"

namespace galilean::mcap {
namespace {

Message message_of(const Small& small) {
  return {.channel_id = small.channel_id,
          .log_ns = small.log_ns,
          .publish_ns = small.log_ns,
          .data = {&small.byte, 1}};
}

Bytes lz4(ByteView bytes) {
  Bytes frame(LZ4F_compressFrameBound(bytes.size(), nullptr));
  frame.resize(LZ4F_compressFrame(frame.data(), frame.size(), bytes.data(), bytes.size(), nullptr));
  return frame;
}

Bytes compressed(const std::string& compression, const Bytes& records) {
  if (compression == "lz4") return lz4(records);
  if (compression.empty()) return records;
  Compressor compressor(Compression::kFast);
  const auto frame = compressor.compress(records);
  return {frame.begin(), frame.end()};
}

}  // namespace

BuiltFile::BuiltFile() {
  bytes.assign(std::begin(kMagic), std::end(kMagic));
  record(Header{"test", "built"});
}

BuiltFile& BuiltFile::channel(std::uint16_t id) {
  record(Schema{id, "test/msg/T" + std::to_string(id), "ros2idl", "module t {};"});
  return record(Channel{.id = id,
                        .schema_id = id,
                        .topic = "/t" + std::to_string(id),
                        .message_encoding = "cdr",
                        .metadata = {}});
}

BuiltFile& BuiltFile::loose(const Small& message) {
  return record(message_of(message));
}

std::size_t BuiltFile::chunk(const std::vector<Small>& messages, const ChunkOptions& options) {
  Bytes records;
  std::map<std::uint16_t, MessageIndex> indexes;
  Chunk chunk{.start_ns = messages.empty() ? 0 : UINT64_MAX};
  for (const auto& message : messages) {
    auto& index = indexes[message.channel_id];
    index.channel_id = message.channel_id;
    index.entries.push_back({message.log_ns, records.size()});
    append(records, message_of(message));
    chunk.start_ns = std::min(chunk.start_ns, message.log_ns);
    chunk.end_ns = std::max(chunk.end_ns, message.log_ns);
  }
  const Bytes stored = compressed(options.compression, records);
  chunk.uncompressed_size = records.size();
  chunk.uncompressed_crc = crc32(records);
  chunk.compression = options.compression;
  chunk.records = stored;
  const std::size_t at = bytes.size();
  record(chunk);
  if (options.indexed)
    for (const auto& [id, index] : indexes) record(index);
  return at;
}

std::vector<Small> read_messages(ByteView file, std::size_t memory_bytes) {
  const MemorySource source(file);
  const Summary summary = summary_of(file);
  MessageReader reader(source, summary.blocks, memory_bytes);
  std::vector<Small> messages;
  while (const Message* message = reader.next())
    messages.push_back({message->channel_id, message->log_ns, message->data[0]});
  return messages;
}

Summary summary_of(ByteView file) {
  auto summary = summarize(MemorySource(file));
  if (!summary) throw std::runtime_error(summary.error().message);
  return std::move(summary).value();
}

}  // namespace galilean::mcap
