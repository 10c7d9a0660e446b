// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "monitor/mcap/mcap_reader.h"
#include "monitor/mcap/mcap_records.h"
#include "monitor/mcap/message_reader.h"

namespace galilean::mcap {

/// A message of one byte.
struct Small {
  std::uint16_t channel_id;
  std::uint64_t log_ns;
  std::uint8_t byte;
  bool operator==(const Small&) const = default;
};

/// A file made record by record, so that it can lack what a Writer always writes.
class BuiltFile {
 public:
  BuiltFile();
  /// Adds a schema and a channel "/tN" outside chunks, both of the id N.
  BuiltFile& channel(std::uint16_t id);
  BuiltFile& loose(const Small& message);
  struct ChunkOptions {
    std::string compression;
    bool indexed = true;
  };
  /// Returns the offset of the chunk.
  std::size_t chunk(const std::vector<Small>& messages, const ChunkOptions& options);
  std::size_t chunk(const std::vector<Small>& messages) { return chunk(messages, {}); }
  template <class Record>
  BuiltFile& record(const Record& record) {
    append(bytes, record);
    return *this;
  }
  /// Adds the end of the data section, and a footer without a summary.
  BuiltFile& close() {
    return close([](Bytes&) {});
  }
  /// The same, with the summary that `fill` appends.
  template <class Fill>
  BuiltFile& close(Fill fill) {
    record(DataEnd{});
    const std::uint64_t summary_at = bytes.size();
    fill(bytes);
    record(Footer{.summary_start = bytes.size() == summary_at ? 0 : summary_at});
    bytes.insert(bytes.end(), std::begin(kMagic), std::end(kMagic));
    return *this;
  }

  Bytes bytes;
};

/// Returns the messages in the order in which a reader gives them.
std::vector<Small> read_messages(ByteView file, std::size_t memory_bytes = std::size_t{48} << 20);
Summary summary_of(ByteView file);

}  // namespace galilean::mcap
