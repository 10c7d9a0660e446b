// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/mcap/mcap_writer.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <utility>

#include "core/visible_text.h"
#include "monitor/mcap/crc32.h"
#include "monitor/mcap/lz4.h"

namespace galilean::mcap {
namespace {
constexpr std::size_t kFooterFieldsBeforeCrc = kRecordHead + 8 + 8;
/// Returns MCAP's name for it.
const char* compression_name(Compression compression) {
  if (compression == Compression::kNone) return "";
  return compression == Compression::kLz4 ? "lz4" : "zstd";
}

constexpr std::size_t kAtOnce = std::size_t{1} << 20;
}  // namespace

Writer::Writer(ByteSink& sink, WriterOptions options)
    : sink_(sink), options_(std::move(options)), compressor_(options_.compression) {}

Result<void> Writer::emit(ByteView bytes) {
  if (!outcome_) return outcome_;
  outcome_ = sink_.write(bytes);
  if (!outcome_) return outcome_;
  position_ += bytes.size();
  crc_ = crc32(bytes, crc_);
  return {};
}

template <class Record>
Result<void> Writer::emit_record(const Record& record) {
  scratch_.clear();
  append(scratch_, record);
  return emit(scratch_);
}

Result<void> Writer::begin() {
  if (auto done = emit(kMagic); !done) return done;
  return emit_record(Header{options_.profile, options_.library});
}

std::uint16_t Writer::add_schema(std::string name, std::string encoding, std::string data) {
  const auto id = ++statistics_.schemas;
  schemas_.push_back({id, std::move(name), std::move(encoding), std::move(data)});
  chunk_.add(schemas_.back());
  return id;
}

std::uint16_t Writer::add_channel(Channel channel) {
  channel.id = static_cast<std::uint16_t>(++statistics_.channels);
  channels_.push_back(std::move(channel));
  chunk_.add(channels_.back());
  return channels_.back().id;
}

Result<void> Writer::write(const Message& message) {
  if (!outcome_) return outcome_;
  if (chunk_is_due(message.log_ns))
    if (auto done = close_chunk(); !done) return done;
  chunk_.add(message);
  const bool first = statistics_.messages++ == 0;
  ++statistics_.channel_messages[message.channel_id];
  statistics_.start_ns = first ? message.log_ns : std::min(statistics_.start_ns, message.log_ns);
  statistics_.end_ns = std::max(statistics_.end_ns, message.log_ns);
  return chunk_.records().size() >= options_.chunk_bytes ? close_chunk() : Result<void>{};
}

Result<void> Writer::write(const Metadata& metadata) {
  const std::uint64_t offset = position_;
  if (auto done = emit_record(metadata); !done) return done;
  metadata_indexes_.push_back({offset, position_ - offset, metadata.name});
  ++statistics_.metadata;
  return {};
}

Result<void> Writer::write(const Attachment& attachment, const ByteSource& source) {
  const std::uint64_t offset = position_;
  scratch_.clear();
  append_head(scratch_, attachment);
  std::uint32_t crc = crc32(ByteView(scratch_).subspan(kRecordHead));
  if (auto done = emit(scratch_); !done) return done;
  if (auto done = emit_attached(attachment, source, crc); !done) return done;
  std::uint8_t end[sizeof crc];
  std::memcpy(end, &crc, sizeof crc);
  if (auto done = emit(end); !done) return done;
  attachment_indexes_.push_back({offset, position_ - offset, attachment.log_ns,
                                 attachment.create_ns, attachment.data_bytes, attachment.name,
                                 attachment.media_type});
  ++statistics_.attachments;
  return {};
}

Result<void> Writer::emit_attached(const Attachment& attachment, const ByteSource& source,
                                   std::uint32_t& crc) {
  for (std::uint64_t done = 0; done < attachment.data_bytes; done += scratch_.size()) {
    scratch_.resize(
        static_cast<std::size_t>(std::min<std::uint64_t>(kAtOnce, attachment.data_bytes - done)));
    if (!source.read(attachment.data_offset + done, scratch_))
      return outcome_ = Error{"the attachment '" + visible(attachment.name) + "' cannot be read"};
    crc = crc32(scratch_, crc);
    if (auto written = emit(scratch_); !written) return written;
  }
  return {};
}

bool Writer::chunk_is_due(std::uint64_t now_ns) const {
  const auto span_ns = static_cast<std::uint64_t>(options_.chunk_span.count());
  return chunk_.end_ns() != 0 && now_ns >= chunk_.start_ns() + span_ns;
}

Result<void> Writer::close_chunk_if_due(std::uint64_t now_ns) {
  return chunk_is_due(now_ns) ? close_chunk() : outcome_;
}

ByteView Writer::compress(ByteView records) {
  if (options_.compression != Compression::kLz4) return compressor_.compress(records);
  compress_lz4(records, frame_);
  return frame_;
}

Result<void> Writer::close_chunk() {
  if (!outcome_ || chunk_.empty()) return outcome_;
  Chunk chunk{.start_ns = chunk_.start_ns(),
              .end_ns = chunk_.end_ns(),
              .uncompressed_size = chunk_.records().size(),
              .uncompressed_crc = crc32(chunk_.records()),
              .compression = compression_name(options_.compression),
              .records = compress(chunk_.records())};
  ChunkIndex index{.start_ns = chunk.start_ns,
                   .end_ns = chunk.end_ns,
                   .offset = position_,
                   .compression = compression_name(options_.compression),
                   .compressed_size = chunk.records.size(),
                   .uncompressed_size = chunk.uncompressed_size};
  if (auto done = emit_record(chunk); !done) return done;
  index.length = position_ - index.offset;
  if (auto done = write_message_indexes(index); !done) return done;
  chunk_indexes_.add(index);
  ++statistics_.chunks;
  chunk_.clear();
  return {};
}

Result<void> Writer::write_message_indexes(ChunkIndex& index) {
  scratch_.clear();
  for (const auto& [channel, messages] : chunk_.indexes()) {
    if (messages.entries.empty()) continue;
    index.message_index_offsets[channel] = position_ + scratch_.size();
    append(scratch_, messages);
  }
  index.message_index_length = scratch_.size();
  return emit(scratch_);
}

Result<void> Writer::end() {
  if (auto done = close_chunk(); !done) return done;
  data_end_ = position_;
  data_crc_ = crc_;
  if (auto done = emit_record(DataEnd{crc_}); !done) return done;
  return write_summary();
}

Result<void> Writer::take_up(std::uint64_t more_bytes) {
  const std::uint64_t end_bytes = position_ - data_end_;
  if (auto done = sink_.go_back(data_end_, end_bytes + more_bytes); !done) return done;
  position_ = data_end_;
  crc_ = data_crc_;
  return {};
}

/// Emits the records that `next` returns until it returns nullptr, in pieces: of a long recording
/// they are many megabytes.
template <class Next>
Result<void> Writer::emit_group(Opcode opcode, Next next, Bytes& offsets) {
  const std::uint64_t start = position_;
  scratch_.clear();
  while (const auto* record = next()) {
    append(scratch_, *record);
    if (scratch_.size() < kAtOnce) continue;
    if (auto done = emit(scratch_); !done) return done;
    scratch_.clear();
  }
  if (auto done = emit(scratch_); !done) return done;
  if (position_ > start) append(offsets, SummaryOffset{opcode, start, position_ - start});
  return {};
}

template <class Records>
Result<void> Writer::emit_all(Opcode opcode, const Records& records, Bytes& offsets) {
  auto at = std::begin(records);
  return emit_group(
      opcode, [&] { return at == std::end(records) ? nullptr : &*at++; }, offsets);
}

Result<void> Writer::write_summary() {
  const std::uint64_t start = position_;
  crc_ = 0;
  Bytes offsets;
  ChunkIndexLog::Reader chunks(chunk_indexes_, compression_name(options_.compression));
  const std::array statistics{statistics_};
  if (auto done = emit_all(Opcode::kSchema, schemas_, offsets); !done) return done;
  if (auto done = emit_all(Opcode::kChannel, channels_, offsets); !done) return done;
  if (auto done = emit_all(Opcode::kStatistics, statistics, offsets); !done) return done;
  if (auto done = emit_group(
          Opcode::kChunkIndex, [&] { return chunks.next(); }, offsets);
      !done)
    return done;
  if (auto done = emit_all(Opcode::kAttachmentIndex, attachment_indexes_, offsets); !done)
    return done;
  if (auto done = emit_all(Opcode::kMetadataIndex, metadata_indexes_, offsets); !done) return done;
  return write_footer(start, offsets);
}

/// Writes the rest of a file whose summary begins at `start`.
Result<void> Writer::write_footer(std::uint64_t start, ByteView offsets) {
  Footer footer{start, position_, 0};
  Bytes end(offsets.begin(), offsets.end());
  append(end, footer);
  footer.summary_crc = crc32(ByteView(end).first(offsets.size() + kFooterFieldsBeforeCrc), crc_);
  end.resize(offsets.size());
  append(end, footer);
  end.insert(end.end(), std::begin(kMagic), std::end(kMagic));
  return emit(end);
}

}  // namespace galilean::mcap
