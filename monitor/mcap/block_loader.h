// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "monitor/mcap/survey.h"

namespace galilean::mcap {

/// The messages of a block in memory.
struct LoadedBlock {
  struct Entry {
    std::uint64_t log_ns;
    std::uint32_t offset;  ///< of the record within `records`
    std::uint16_t channel_id;
  };
  Bytes bytes;  ///< the memory that `records` lies in
  ByteView records;
  std::vector<Entry> entries;  ///< by log time; messages of one time are in the order of the file
  std::vector<Schema> schemas;
  std::vector<Channel> channels;
  std::optional<Damage> damage;

  /// Returns the message, whose data points into `records`.
  [[nodiscard]] Message message(const Entry& entry) const;
  /// Returns about how much memory the block takes [bytes].
  [[nodiscard]] std::size_t memory() const noexcept;
};

/// Reads blocks of one file. It is the one place that decides which messages of a recording are
/// damaged.
class BlockLoader {
 public:
  explicit BlockLoader(const ByteSource& source) : source_(source) {}

  /// Reads the block into `to`, whose memory is used again. A chunk that fails its checksum gives
  /// no message, since none of them can be trusted. What is lost is counted by the chunk's message
  /// indexes, if it has any.
  void load(const Block& block, LoadedBlock& to);

 private:
  [[nodiscard]] std::string read(const Block& block, LoadedBlock& to);
  [[nodiscard]] Damage assess(const Block& block, const std::string& problem,
                              const LoadedBlock& loaded) const;

  const ByteSource& source_;
  Bytes stored_;
};

}  // namespace galilean::mcap
