// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "monitor/mcap/block_loader.h"

namespace galilean::mcap {

/// Tells which channels have messages in which block of a recording. A chunk's message indexes tell
/// it without the chunk. They are read when they are asked for, and once.
class BlockChannels {
 public:
  /// How many messages of a channel stand in a block.
  struct Count {
    std::uint16_t channel_id = 0;
    std::uint32_t messages = 0;
  };
  using Counts = std::vector<Count>;

  /// Requires: `source` and `blocks` outlive this.
  BlockChannels(const ByteSource& source, const std::vector<Block>& blocks)
      : source_(source), blocks_(blocks), known_(blocks.size()), asked_(blocks.size()) {}

  /// Returns the channels that have messages in the block, each once. Returns nullptr if the block
  /// has no indexes, or damaged ones: then only reading the block tells it.
  [[nodiscard]] const Counts* of(std::size_t block);
  /// Keeps what a block was found to hold.
  void learn(std::size_t block, const LoadedBlock& content);

 private:
  [[nodiscard]] std::optional<Counts> read(const Block& block) const;

  const ByteSource& source_;
  const std::vector<Block>& blocks_;
  std::vector<std::optional<Counts>> known_;
  std::vector<bool> asked_;
};

}  // namespace galilean::mcap
