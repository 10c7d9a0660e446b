// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <vector>

namespace galilean::mcap {

// The records of MCAP, version 0 (mcap.dev/spec). A record is its opcode, its length and its
// content. Numbers are little-endian. Times are nanoseconds since the Unix epoch. Offsets are bytes
// from the start of the file.

using Bytes = std::vector<std::uint8_t>;
using ByteView = std::span<const std::uint8_t>;

inline constexpr std::uint8_t kMagic[8] = {0x89, 'M', 'C', 'A', 'P', '0', '\r', '\n'};
inline constexpr std::size_t kRecordHead = 1 + 8;  ///< opcode and length
inline constexpr std::size_t kDataEndBytes = kRecordHead + 4;
inline constexpr std::size_t kFooterBytes = kRecordHead + 8 + 8 + 4;

enum class Opcode : std::uint8_t {
  kHeader = 0x01,
  kFooter = 0x02,
  kSchema = 0x03,
  kChannel = 0x04,
  kMessage = 0x05,
  kChunk = 0x06,
  kMessageIndex = 0x07,
  kChunkIndex = 0x08,
  kAttachment = 0x09,
  kAttachmentIndex = 0x0a,
  kStatistics = 0x0b,
  kMetadata = 0x0c,
  kMetadataIndex = 0x0d,
  kSummaryOffset = 0x0e,
  kDataEnd = 0x0f
};

using Text = std::map<std::string, std::string>;

struct Header {
  std::string profile, library;
};
struct Footer {
  std::uint64_t summary_start = 0, summary_offset_start = 0;
  std::uint32_t summary_crc = 0;
};
struct Schema {
  std::uint16_t id = 0;
  std::string name, encoding, data;
};
struct Channel {
  std::uint16_t id = 0, schema_id = 0;
  std::string topic, message_encoding;
  Text metadata;
};
struct Message {
  std::uint16_t channel_id = 0;
  std::uint32_t sequence = 0;
  std::uint64_t log_ns = 0, publish_ns = 0;
  ByteView data;
};
struct Chunk {
  std::uint64_t start_ns = 0, end_ns = 0;
  std::uint64_t uncompressed_size = 0;
  std::uint32_t uncompressed_crc = 0;
  std::string compression;
  ByteView records;
};
struct MessageIndex {
  struct Entry {
    std::uint64_t log_ns, offset;  ///< offset within the uncompressed chunk
  };
  std::uint16_t channel_id = 0;
  std::vector<Entry> entries;
};
struct ChunkIndex {
  std::uint64_t start_ns = 0, end_ns = 0;
  std::uint64_t offset = 0, length = 0;
  std::map<std::uint16_t, std::uint64_t> message_index_offsets;
  std::uint64_t message_index_length = 0;
  std::string compression;
  std::uint64_t compressed_size = 0, uncompressed_size = 0;
};
/// An attachment without its data, which may be larger than memory.
struct Attachment {
  std::uint64_t log_ns = 0, create_ns = 0;
  std::string name, media_type;
  std::uint64_t data_bytes = 0;
  std::uint64_t data_offset = 0;  ///< where in the file its data is; no part of the record
};
struct AttachmentIndex {
  std::uint64_t offset = 0, length = 0;
  std::uint64_t log_ns = 0, create_ns = 0, data_bytes = 0;
  std::string name, media_type;
};
struct Metadata {
  std::string name;
  Text entries;
};
struct MetadataIndex {
  std::uint64_t offset = 0, length = 0;
  std::string name;
};
struct Statistics {
  std::uint64_t messages = 0;
  std::uint16_t schemas = 0;
  std::uint32_t channels = 0, attachments = 0, metadata = 0, chunks = 0;
  std::uint64_t start_ns = 0, end_ns = 0;
  std::map<std::uint16_t, std::uint64_t> channel_messages;
};
struct SummaryOffset {
  Opcode group = Opcode::kHeader;
  std::uint64_t start = 0, length = 0;
};
struct DataEnd {
  std::uint32_t crc = 0;
};

/// Appends the record with its opcode and length to `to`.
void append(Bytes& to, const Header& record);
void append(Bytes& to, const Footer& record);
void append(Bytes& to, const Schema& record);
void append(Bytes& to, const Channel& record);
void append(Bytes& to, const Message& record);
void append(Bytes& to, const Chunk& record);
void append(Bytes& to, const MessageIndex& record);
void append(Bytes& to, const ChunkIndex& record);
void append(Bytes& to, const AttachmentIndex& record);
void append(Bytes& to, const Metadata& record);
void append(Bytes& to, const MetadataIndex& record);
void append(Bytes& to, const Statistics& record);
void append(Bytes& to, const SummaryOffset& record);
void append(Bytes& to, const DataEnd& record);
/// Appends the attachment's record up to where its data begins. Behind the data stands a checksum
/// of all that is between the record's length and itself.
void append_head(Bytes& to, const Attachment& record);

/// Reads a record from its content, without opcode and length. `data` of a message and `records` of
/// a chunk point into `content`. Of an attachment, `content` may end where its data begins. Returns
/// false if the content is cut short or invalid. Skips fields that later versions may have added.
[[nodiscard]] bool parse(ByteView content, Header& record);
[[nodiscard]] bool parse(ByteView content, Footer& record);
[[nodiscard]] bool parse(ByteView content, Schema& record);
[[nodiscard]] bool parse(ByteView content, Channel& record);
[[nodiscard]] bool parse(ByteView content, Message& record);
[[nodiscard]] bool parse(ByteView content, Chunk& record);
[[nodiscard]] bool parse(ByteView content, MessageIndex& record);
[[nodiscard]] bool parse(ByteView content, ChunkIndex& record);
[[nodiscard]] bool parse(ByteView content, Attachment& record);
[[nodiscard]] bool parse(ByteView content, Metadata& record);
[[nodiscard]] bool parse(ByteView content, MetadataIndex& record);
[[nodiscard]] bool parse(ByteView content, Statistics& record);
[[nodiscard]] bool parse(ByteView content, DataEnd& record);

}  // namespace galilean::mcap
