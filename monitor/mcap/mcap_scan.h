// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>

#include "monitor/mcap/byte_source.h"
#include "monitor/mcap/mcap_records.h"

namespace galilean::mcap {

/// What a scan tells of, in the order of the file. Any may be empty.
struct Visitor {
  std::function<void(const Header&)> header;
  std::function<void(const Schema&)> schema;
  std::function<void(const Channel&)> channel;
  std::function<void(const Message&)> message;  ///< its bytes are valid during the call only
  std::function<void(const Chunk&)> chunk;      ///< one that was whole, before what it contains
  std::function<void(const Metadata&)> metadata;
  std::function<bool()> enough;  ///< asked before each record; the scan ends where it says true
};

/// How far a scan came.
struct ScanEnd {
  bool complete = false;  ///< it reached the end of the data section
  std::uint64_t offset = 0;
  /// One sentence a part that could not be read, with its place.
  std::vector<std::string> damage;
};

/// Reads the data section from its start, without the summary: what is there of a file whose
/// recorder was killed. A damaged chunk is left out; after a record that ends too early nothing
/// follows. Never throws for what is in the file.
[[nodiscard]] ScanEnd scan(const ByteSource& source, const Visitor& visitor);

/// Reads one record at `offset`: its opcode, and its content into `content`. False if it does not
/// end within the file.
[[nodiscard]] bool read_record(const ByteSource& source, std::uint64_t offset, Opcode& opcode,
                               Bytes& content);

}  // namespace galilean::mcap
