// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "monitor/mcap/mcap_records.h"

namespace galilean::mcap {

/// Keeps the indexes of a recording's chunks until its end, where they are written. A recording of
/// thirty robots has 400 channels in each chunk and a chunk each second, so that a ChunkIndex of
/// each would fill 100 MiB in an hour. Here a channel of a chunk takes three bytes: numbers are
/// kept as differences from those before them, and small ones in few bytes.
class ChunkIndexLog {
 public:
  /// Its compression is not kept: it is the same for all chunks of a writer.
  void add(const ChunkIndex& index);
  /// Returns how many bytes it takes.
  [[nodiscard]] std::size_t bytes() const noexcept;

  /// Goes through the indexes in the order in which they were added.
  class Reader {
   public:
    /// Requires: nothing is added to `log` while this is used.
    Reader(const ChunkIndexLog& log, const std::string& compression) : log_(log) {
      index_.compression = compression;
    }
    /// Returns the next index, which stays until the next call; nullptr behind the last.
    [[nodiscard]] const ChunkIndex* next();

   private:
    std::uint64_t take();

    const ChunkIndexLog& log_;
    std::size_t page_ = 0, at_ = 0;
    ChunkIndex index_;
  };

 private:
  void put(std::uint64_t number);

  /// Pages do not move as more are added: no moment needs twice the memory.
  std::vector<Bytes> pages_;
  std::uint64_t start_ns_ = 0, end_ = 0;  ///< of the index that was added last
};

}  // namespace galilean::mcap
