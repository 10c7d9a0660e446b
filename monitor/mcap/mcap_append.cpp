// SPDX-License-Identifier: BSD-3-Clause
#include <array>
#include <bit>
#include <cstring>

#include "monitor/mcap/mcap_records.h"

namespace galilean::mcap {
namespace {

static_assert(std::endian::native == std::endian::little, "numbers are copied as they lie");

template <class T>
requires std::is_integral_v<T>
void put(Bytes& to, T number) {
  const auto at = to.size();
  to.resize(at + sizeof number);
  std::memcpy(to.data() + at, &number, sizeof number);
}
void put(Bytes& to, ByteView bytes) {
  to.insert(to.end(), bytes.begin(), bytes.end());
}
void put(Bytes& to, const std::string& text) {
  put(to, static_cast<std::uint32_t>(text.size()));
  to.insert(to.end(), text.begin(), text.end());
}
void put(Bytes& to, const std::vector<MessageIndex::Entry>& entries) {
  static_assert(sizeof(MessageIndex::Entry) == 2 * sizeof(std::uint64_t),
                "they are copied as they lie");
  put(to, ByteView(reinterpret_cast<const std::uint8_t*>(entries.data()),
                   entries.size() * sizeof(MessageIndex::Entry)));
}

/// Returns numbers as they stand one behind the other in a record.
template <class... Numbers>
auto packed(Numbers... numbers) {
  std::array<std::uint8_t, (sizeof numbers + ...)> bytes{};
  auto* at = bytes.data();
  ((std::memcpy(at, &numbers, sizeof numbers), at += sizeof numbers), ...);
  return bytes;
}

/// Appends the bytes that `fill` appends, with their count before them as a number of type Size.
template <class Size, class Fill>
void put_sized(Bytes& to, Fill fill) {
  const auto at = to.size();
  put(to, Size{0});
  fill();
  const auto size = static_cast<Size>(to.size() - at - sizeof(Size));
  std::memcpy(to.data() + at, &size, sizeof size);
}

template <class Key, class Value>
void put(Bytes& to, const std::map<Key, Value>& map) {
  put_sized<std::uint32_t>(to, [&] {
    for (const auto& [key, value] : map) {
      put(to, key);
      put(to, value);
    }
  });
}

template <class... Fields>
void put_record(Bytes& to, Opcode opcode, const Fields&... fields) {
  to.push_back(static_cast<std::uint8_t>(opcode));
  put_sized<std::uint64_t>(to, [&] { (put(to, fields), ...); });
}

}  // namespace

void append(Bytes& to, const Header& r) {
  put_record(to, Opcode::kHeader, r.profile, r.library);
}
void append(Bytes& to, const Footer& r) {
  put_record(to, Opcode::kFooter, r.summary_start, r.summary_offset_start, r.summary_crc);
}
void append(Bytes& to, const Schema& r) {
  put_record(to, Opcode::kSchema, r.id, r.name, r.encoding, r.data);
}
void append(Bytes& to, const Channel& r) {
  put_record(to, Opcode::kChannel, r.id, r.schema_id, r.topic, r.message_encoding, r.metadata);
}
void append(Bytes& to, const Message& r) {
  // The commonest record by far: room is made for its numbers once, not for each.
  constexpr std::uint64_t kNumberBytes = 2 + 4 + 8 + 8;
  put(to, packed(static_cast<std::uint8_t>(Opcode::kMessage), kNumberBytes + r.data.size(),
                 r.channel_id, r.sequence, r.log_ns, r.publish_ns));
  put(to, r.data);
}
void append(Bytes& to, const Chunk& r) {
  put_record(to, Opcode::kChunk, r.start_ns, r.end_ns, r.uncompressed_size, r.uncompressed_crc,
             r.compression, std::uint64_t{r.records.size()}, r.records);
}
void append(Bytes& to, const MessageIndex& r) {
  to.push_back(static_cast<std::uint8_t>(Opcode::kMessageIndex));
  put_sized<std::uint64_t>(to, [&] {
    put(to, r.channel_id);
    put_sized<std::uint32_t>(to, [&] { put(to, r.entries); });
  });
}
void append(Bytes& to, const ChunkIndex& r) {
  put_record(to, Opcode::kChunkIndex, r.start_ns, r.end_ns, r.offset, r.length,
             r.message_index_offsets, r.message_index_length, r.compression, r.compressed_size,
             r.uncompressed_size);
}
void append(Bytes& to, const AttachmentIndex& r) {
  put_record(to, Opcode::kAttachmentIndex, r.offset, r.length, r.log_ns, r.create_ns, r.data_bytes,
             r.name, r.media_type);
}
void append(Bytes& to, const Metadata& r) {
  put_record(to, Opcode::kMetadata, r.name, r.entries);
}
void append(Bytes& to, const MetadataIndex& r) {
  put_record(to, Opcode::kMetadataIndex, r.offset, r.length, r.name);
}
void append(Bytes& to, const Statistics& r) {
  put_record(to, Opcode::kStatistics, r.messages, r.schemas, r.channels, r.attachments, r.metadata,
             r.chunks, r.start_ns, r.end_ns, r.channel_messages);
}
void append(Bytes& to, const SummaryOffset& r) {
  put_record(to, Opcode::kSummaryOffset, static_cast<std::uint8_t>(r.group), r.start, r.length);
}
void append(Bytes& to, const DataEnd& r) {
  put_record(to, Opcode::kDataEnd, r.crc);
}
void append_head(Bytes& to, const Attachment& r) {
  const auto at = to.size();
  put_record(to, Opcode::kAttachment, r.log_ns, r.create_ns, r.name, r.media_type, r.data_bytes);
  const std::uint64_t length = to.size() - at - kRecordHead + r.data_bytes + sizeof(std::uint32_t);
  std::memcpy(to.data() + at + 1, &length, sizeof length);
}

}  // namespace galilean::mcap
