// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/clock.h"
#include "monitor/mcap/byte_sink.h"
#include "monitor/mcap/byte_source.h"
#include "monitor/mcap/chunk_builder.h"
#include "monitor/mcap/chunk_index_log.h"
#include "monitor/mcap/mcap_records.h"
#include "monitor/mcap/zstd.h"

namespace galilean::mcap {

struct WriterOptions {
  std::string profile = "ros2";
  std::string library = "galilean";
  std::size_t chunk_bytes = std::size_t{1} << 20;  ///< a chunk closes when it holds so many bytes
  Duration chunk_span = std::chrono::seconds(1);   ///< or when it spans so much log time
  Compression compression = Compression::kFast;
};

/// Writes an MCAP file: compressed chunks with indexes and checksums, and a summary at the end.
/// Each chunk is written whole, in order, and never changed afterwards, so all closed chunks can be
/// read even if the recording breaks off. After the first failure nothing more is written, and
/// every call returns that failure.
class Writer {
 public:
  explicit Writer(ByteSink& sink, WriterOptions options = {});

  /// Writes the start of the file. Call it once, before all others.
  Result<void> begin();
  /// Returns the new schema's id, from 1. Schemas and channels stand in the file before their first
  /// message, and again in the summary.
  [[nodiscard]] std::uint16_t add_schema(std::string name, std::string encoding, std::string data);
  /// Returns the new channel's id, from 1; `channel.id` is ignored.
  [[nodiscard]] std::uint16_t add_channel(Channel channel);
  /// Adds a message to the open chunk, and copies its data.
  Result<void> write(const Message& message);
  /// Writes a metadata record at once, before the open chunk.
  Result<void> write(const Metadata& metadata);
  /// Writes an attachment at once, whose data stands in `source` at `attachment.data_offset`. It is
  /// copied piece by piece, so that it may be larger than memory. Errors: also if it cannot be read
  /// whole; nothing can be written behind it then.
  Result<void> write(const Attachment& attachment, const ByteSource& source);
  /// Closes the chunk if its span is over at `now_ns`, so that messages do not stay in memory while
  /// no more arrive.
  Result<void> close_chunk_if_due(std::uint64_t now_ns);
  /// Closes the last chunk and writes the summary. Call nothing that writes after it, but for
  /// `take_up`.
  Result<void> end();
  /// Takes the end back, so that `more_bytes` of metadata can be written, and `end` be called
  /// again. Makes sure before that there is room for it. Requires: `end` was the last call, and
  /// succeeded. Errors: there is no room, or the sink cannot go back; the file is as it was.
  Result<void> take_up(std::uint64_t more_bytes);

  [[nodiscard]] const Statistics& statistics() const noexcept { return statistics_; }
  [[nodiscard]] std::uint64_t bytes_written() const noexcept { return position_; }

 private:
  bool chunk_is_due(std::uint64_t now_ns) const;
  Result<void> close_chunk();
  Result<void> write_message_indexes(ChunkIndex& index);
  Result<void> write_summary();
  Result<void> write_footer(std::uint64_t start, ByteView offsets);
  [[nodiscard]] ByteView compress(ByteView records);
  Result<void> emit(ByteView bytes);
  Result<void> emit_attached(const Attachment& attachment, const ByteSource& source,
                             std::uint32_t& crc);
  template <class Record>
  Result<void> emit_record(const Record& record);
  template <class Next>
  Result<void> emit_group(Opcode opcode, Next next, Bytes& offsets);
  template <class Records>
  Result<void> emit_all(Opcode opcode, const Records& records, Bytes& offsets);

  ByteSink& sink_;
  WriterOptions options_;
  Compressor compressor_;
  ChunkBuilder chunk_;
  Bytes scratch_, frame_;
  std::uint64_t position_ = 0;
  std::uint32_t crc_ = 0;       ///< of the data section, and then of the summary
  std::uint64_t data_end_ = 0;  ///< where the summary was begun
  std::uint32_t data_crc_ = 0;
  Result<void> outcome_;
  std::vector<Schema> schemas_;
  std::vector<Channel> channels_;
  ChunkIndexLog chunk_indexes_;
  std::vector<MetadataIndex> metadata_indexes_;
  std::vector<AttachmentIndex> attachment_indexes_;
  Statistics statistics_;
};

}  // namespace galilean::mcap
