// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "monitor/mcap/byte_source.h"
#include "monitor/mcap/damage.h"
#include "monitor/mcap/mcap_records.h"

namespace galilean::mcap {

/// What stands behind a file's data section. The format allows it to lack any of it.
struct SummarySection {
  bool closed = false;         ///< whether the file has its footer and its last bytes
  std::uint64_t data_end = 0;  ///< offset behind the data section; 0 if not closed
  bool checked = false;        ///< whether it matches a checksum
  std::map<std::uint16_t, Schema> schemas;
  std::map<std::uint16_t, Channel> channels;
  std::optional<Statistics> statistics;
  std::vector<ChunkIndex> chunks;  ///< without the offsets of their message indexes
  std::optional<Damage> damage;    ///< if set, all the rest but `closed` is empty
};

/// Reads the summary section, record by record: that of a recording of a day may have hundreds of
/// megabytes. Never throws because of the file's content.
[[nodiscard]] SummarySection read_summary_section(const ByteSource& source);

}  // namespace galilean::mcap
