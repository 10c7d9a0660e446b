// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "monitor/mcap/byte_source.h"
#include "monitor/mcap/damage.h"
#include "monitor/mcap/mcap_records.h"

namespace galilean::mcap {

/// A part of the data section that is read at once: a chunk, or messages that stand one behind the
/// other outside chunks.
struct Block {
  bool is_chunk = true;
  std::uint64_t offset = 0;  ///< of its first record
  std::uint64_t bytes = 0;   ///< with the heads of its records
  /// The log times [ns since the Unix epoch] that the file states for it; 0 without messages.
  std::uint64_t start_ns = 0, end_ns = 0;
  std::uint64_t uncompressed_bytes = 0;             ///< as the file states it
  std::uint64_t index_offset = 0, index_bytes = 0;  ///< its message indexes; 0 bytes: it has none
};

/// What stands in a file's data section, without the contents of its chunks.
struct Survey {
  Header header;
  std::map<std::uint16_t, Schema> schemas;    ///< those outside chunks
  std::map<std::uint16_t, Channel> channels;  ///< those outside chunks
  std::vector<Metadata> metadata;
  std::vector<Attachment> attachments;
  std::map<std::string, std::uint32_t> compressions;  ///< number of chunks; "" is uncompressed
  std::vector<Block> blocks;                          ///< in the order of the file
  std::vector<Damage> damages;                        ///< parts that are no records
  bool complete = false;                              ///< whether the data section has its end
  std::uint64_t end = 0;  ///< offset of the DataEnd record; of the first unread byte without one
  std::uint32_t data_crc = 0;  ///< as the file states it; 0 if it does not
};

/// Goes through the data section from record to record, and passes over the content of chunks.
/// Where it meets what is no record, it goes on at the next chunk that it can find. Never throws
/// because of the file's content.
/// @param known  the chunks that a summary with a right checksum lists; they are found even if
/// their
///               heads are damaged
/// @param data_end  offset at which the data section must end; 0 if it is not known
[[nodiscard]] Survey survey(const ByteSource& source, std::vector<ChunkIndex> known,
                            std::uint64_t data_end);

}  // namespace galilean::mcap
