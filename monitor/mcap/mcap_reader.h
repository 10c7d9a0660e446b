// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/result.h"
#include "monitor/mcap/byte_source.h"
#include "monitor/mcap/mcap_records.h"

namespace galilean::mcap {

/// The contents of a recording.
struct Summary {
  Header header;
  std::map<std::uint16_t, Schema> schemas;
  std::map<std::uint16_t, Channel> channels;
  Statistics statistics;
  std::map<std::string, std::uint32_t> compressions;  ///< number of chunks; "" is uncompressed
  std::vector<std::string> attachments;               ///< names
  std::vector<Metadata> metadata;
  std::uint64_t bytes = 0;  ///< size of the file
  /// Whether the file was not closed or is damaged. The contents were then counted from the chunks
  /// that are whole.
  bool recovered = false;
  std::vector<std::string> damage;  ///< as in ScanEnd
};

/// Reads the file's summary if it is whole and matches its checksum, else scans the whole file.
/// Errors: the file is empty or no MCAP file. The message is a predicate, so that the caller can
/// put the file's name before it.
[[nodiscard]] Result<Summary> summarize(const ByteSource& source);

}  // namespace galilean::mcap
