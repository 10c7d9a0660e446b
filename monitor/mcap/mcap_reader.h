// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/result.h"
#include "monitor/mcap/byte_source.h"
#include "monitor/mcap/mcap_records.h"

namespace galilean::mcap {

/// What a recording contains.
struct Summary {
  Header header;
  std::map<std::uint16_t, Schema> schemas;
  std::map<std::uint16_t, Channel> channels;
  Statistics statistics;
  std::map<std::string, std::uint32_t> compressions;  ///< chunks of each; "" for none
  std::vector<Metadata> metadata;
  std::uint64_t bytes = 0;  ///< of the file
  /// The recorder did not close it: all here was counted from the chunks that are whole.
  bool recovered = false;
  std::vector<std::string> damage;  ///< as in ScanEnd
};

/// From the file's own summary, where that is whole and matches its checksum; else by scanning the
/// file. Fails if this is no MCAP file, without a name before the sentence.
[[nodiscard]] Result<Summary> summarize(const ByteSource& source);

}  // namespace galilean::mcap
