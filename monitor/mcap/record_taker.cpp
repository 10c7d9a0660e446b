// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/mcap/record_taker.h"

#include <algorithm>
#include <utility>

#include "monitor/mcap/resync.h"
#include "monitor/mcap/unpack.h"

namespace galilean::mcap {
namespace {

/// Messages outside chunks are read in blocks of about so many bytes.
constexpr std::uint64_t kLooseBytes = std::uint64_t{1} << 20;
/// The part of an attachment before its data that is looked at; a longer name is damage.
constexpr std::size_t kAttachmentHead = 64 * 1024;
constexpr std::size_t kMessageHead = 2 + 4 + 8 + 8;

}  // namespace

ByteView RecordTaker::content_of(const RecordPlace& record, std::size_t size) {
  return window_.at(record.offset + kRecordHead, size);
}

template <class Content>
bool RecordTaker::take_content(const RecordPlace& record, Content& content) {
  const bool fits = record.length <= kMaxBlockBytes;
  return fits && parse(content_of(record, static_cast<std::size_t>(record.length)), content);
}

bool RecordTaker::take_metadata(const RecordPlace& record) {
  Metadata metadata;
  if (!take_content(record, metadata)) return false;
  found_.metadata.push_back(std::move(metadata));
  return true;
}

template <class Content>
bool RecordTaker::take_numbered(const RecordPlace& record, std::map<std::uint16_t, Content>& all) {
  Content content;
  if (!take_content(record, content)) return false;
  all[content.id] = std::move(content);
  return true;
}

bool RecordTaker::take_message(const RecordPlace& record) {
  Message message;
  if (record.length < kMessageHead || !parse(content_of(record, kMessageHead), message))
    return false;
  const bool joins = !found_.blocks.empty() && !found_.blocks.back().is_chunk &&
                     found_.blocks.back().offset + found_.blocks.back().bytes == record.offset &&
                     found_.blocks.back().bytes + record.bytes() <= kLooseBytes;
  if (!joins)
    found_.blocks.push_back({.is_chunk = false,
                             .offset = record.offset,
                             .start_ns = message.log_ns,
                             .end_ns = message.log_ns});
  Block& block = found_.blocks.back();
  block.bytes += record.bytes();
  block.uncompressed_bytes = block.bytes;
  block.start_ns = std::min(block.start_ns, message.log_ns);
  block.end_ns = std::max(block.end_ns, message.log_ns);
  return true;
}

bool RecordTaker::take_chunk(const RecordPlace& record) {
  const auto chunk = chunk_head_at(window_, record.offset);
  if (!chunk) return false;
  ++found_.compressions[chunk->compression];
  found_.blocks.push_back({.offset = record.offset,
                           .bytes = record.bytes(),
                           .start_ns = chunk->start_ns,
                           .end_ns = chunk->end_ns,
                           .uncompressed_bytes = chunk->uncompressed_size,
                           .index_offset = record.offset + record.bytes()});
  indexed_ = true;
  return true;
}

bool RecordTaker::take_message_index(const RecordPlace& record) {
  if (indexed_) found_.blocks.back().index_bytes += record.bytes();
  return true;
}

bool RecordTaker::take_attachment(const RecordPlace& record) {
  const auto head = std::min<std::uint64_t>(record.length, kAttachmentHead);
  Attachment attachment;
  if (!parse(content_of(record, static_cast<std::size_t>(head)), attachment) ||
      attachment.data_bytes > record.length)
    return false;
  constexpr std::size_t kNumbers = 8 + 8 + 4 + 4 + 8;  // the times, and the lengths of what follows
  attachment.data_offset = record.offset + kRecordHead + kNumbers + attachment.name.size() +
                           attachment.media_type.size();
  found_.attachments.push_back(std::move(attachment));
  return true;
}

bool RecordTaker::take_end(const RecordPlace& record) {
  DataEnd end;
  const bool right = record.bytes() == kDataEndBytes && take_content(record, end) &&
                     (data_end_ == 0 || record.offset + kDataEndBytes == data_end_);
  if (!right) return false;
  found_.data_crc = end.crc;
  return found_.complete = over_ = true;
}

bool RecordTaker::take(const RecordPlace& record) {
  if (record.opcode != Opcode::kMessageIndex) indexed_ = false;
  switch (record.opcode) {
    case Opcode::kHeader:
      return take_content(record, found_.header);
    case Opcode::kSchema:
      return take_numbered(record, found_.schemas);
    case Opcode::kChannel:
      return take_numbered(record, found_.channels);
    case Opcode::kMetadata:
      return take_metadata(record);
    case Opcode::kMessage:
      return take_message(record);
    case Opcode::kChunk:
      return take_chunk(record);
    case Opcode::kMessageIndex:
      return take_message_index(record);
    case Opcode::kAttachment:
      return take_attachment(record);
    case Opcode::kDataEnd:
      return take_end(record);
    case Opcode::kFooter:
      return found_.complete = over_ = data_end_ == 0 || record.offset >= data_end_;
    default:
      return true;  // a kind that a later version may define
  }
}

}  // namespace galilean::mcap
