// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>

#include "monitor/mcap/byte_source.h"
#include "monitor/mcap/mcap_records.h"

namespace galilean::mcap {

/// The functions that a scan calls for the file's records, in the order of the file. Any may be
/// empty.
struct Visitor {
  std::function<void(const Header&)> header;
  std::function<void(const Schema&)> schema;
  std::function<void(const Channel&)> channel;
  std::function<void(const Message&)> message;  ///< its bytes are valid during the call only
  std::function<void(const Chunk&)> chunk;      ///< called for a whole chunk, before its records
  std::function<void(const Attachment&)> attachment;  ///< as with a message's bytes
  std::function<void(const Metadata&)> metadata;
  std::function<bool()> enough;  ///< called before each record; true ends the scan
};

/// The end of a scan.
struct ScanEnd {
  bool complete = false;  ///< whether the scan reached the end of the data section
  std::uint64_t offset = 0;
  /// One sentence for each part that could not be read, with its place.
  std::vector<std::string> damage;
};

/// Reads the data section from its start, without the summary, so that a file whose recorder was
/// killed can be read. A damaged chunk or record is left out. A record that is cut short ends the
/// scan. Never throws because of the file's content.
[[nodiscard]] ScanEnd scan(const ByteSource& source, const Visitor& visitor);

/// Reads the record at `offset` (bytes from the start of the file) into `opcode` and `content`.
/// Returns false if the record does not end within the file.
[[nodiscard]] bool read_record(const ByteSource& source, std::uint64_t offset, Opcode& opcode,
                               Bytes& content);

}  // namespace galilean::mcap
