// SPDX-License-Identifier: BSD-3-Clause
#include <cstring>
#include <type_traits>

#include "monitor/mcap/mcap_records.h"

namespace galilean::mcap {
namespace {

/// Reads fields from the front of the bytes. If a field does not fit, it and all later ones fail.
class Fields {
 public:
  explicit Fields(ByteView bytes) : rest_(bytes) {}
  [[nodiscard]] bool ok() const noexcept { return ok_; }
  [[nodiscard]] bool empty() const noexcept { return !ok_ || rest_.empty(); }

  template <class T>
  requires std::is_integral_v<T>
  void take(T& number) {
    const ByteView bytes = take_bytes(sizeof number);
    if (ok_) std::memcpy(&number, bytes.data(), sizeof number);
  }
  void take(std::string& text) {
    std::uint32_t size = 0;
    take(size);
    const ByteView bytes = take_bytes(size);
    text.assign(bytes.begin(), bytes.end());
  }
  template <class Key, class Value>
  void take(std::map<Key, Value>& map) {
    std::uint32_t size = 0;
    take(size);
    Fields entries(take_bytes(size));
    while (!entries.empty()) {
      Key key{};
      Value value{};
      entries.take(key);
      entries.take(value);
      if (entries.ok()) map[std::move(key)] = std::move(value);
    }
    ok_ = ok_ && entries.ok();
  }
  ByteView take_bytes(std::uint64_t size) {
    if (size > rest_.size()) ok_ = false;
    if (!ok_) return {};
    const ByteView bytes = rest_.first(static_cast<std::size_t>(size));
    rest_ = rest_.subspan(static_cast<std::size_t>(size));
    return bytes;
  }
  [[nodiscard]] ByteView rest() const noexcept { return rest_; }

 private:
  ByteView rest_;
  bool ok_ = true;
};

template <class... To>
bool take_all(ByteView content, To&... to) {
  Fields fields(content);
  (fields.take(to), ...);
  return fields.ok();
}

}  // namespace

bool parse(ByteView content, Header& r) {
  return take_all(content, r.profile, r.library);
}
bool parse(ByteView content, Footer& r) {
  return take_all(content, r.summary_start, r.summary_offset_start, r.summary_crc);
}
bool parse(ByteView content, Schema& r) {
  return take_all(content, r.id, r.name, r.encoding, r.data) && r.id != 0;
}
bool parse(ByteView content, Channel& r) {
  return take_all(content, r.id, r.schema_id, r.topic, r.message_encoding, r.metadata);
}
bool parse(ByteView content, Message& r) {
  Fields fields(content);
  fields.take(r.channel_id);
  fields.take(r.sequence);
  fields.take(r.log_ns);
  fields.take(r.publish_ns);
  r.data = fields.rest();
  return fields.ok();
}
bool parse(ByteView content, Chunk& r) {
  Fields fields(content);
  fields.take(r.start_ns);
  fields.take(r.end_ns);
  fields.take(r.uncompressed_size);
  fields.take(r.uncompressed_crc);
  fields.take(r.compression);
  std::uint64_t size = 0;
  fields.take(size);
  r.records = fields.take_bytes(size);
  return fields.ok();
}
bool parse(ByteView content, MessageIndex& r) {
  Fields fields(content);
  std::uint32_t size = 0;
  fields.take(r.channel_id);
  fields.take(size);
  Fields entries(fields.take_bytes(size));
  r.entries.clear();
  while (!entries.empty()) {
    MessageIndex::Entry entry{};
    entries.take(entry.log_ns);
    entries.take(entry.offset);
    if (entries.ok()) r.entries.push_back(entry);
  }
  return fields.ok() && entries.ok();
}
bool parse(ByteView content, ChunkIndex& r) {
  return take_all(content, r.start_ns, r.end_ns, r.offset, r.length, r.message_index_offsets,
                  r.message_index_length, r.compression, r.compressed_size, r.uncompressed_size);
}
bool parse(ByteView content, Attachment& r) {
  return take_all(content, r.log_ns, r.create_ns, r.name, r.media_type, r.data_bytes);
}
bool parse(ByteView content, Metadata& r) {
  return take_all(content, r.name, r.entries);
}
bool parse(ByteView content, MetadataIndex& r) {
  return take_all(content, r.offset, r.length, r.name);
}
bool parse(ByteView content, Statistics& r) {
  return take_all(content, r.messages, r.schemas, r.channels, r.attachments, r.metadata, r.chunks,
                  r.start_ns, r.end_ns, r.channel_messages);
}
bool parse(ByteView content, DataEnd& r) {
  return take_all(content, r.crc);
}

}  // namespace galilean::mcap
