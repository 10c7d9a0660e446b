// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "monitor/mcap/block_channels.h"
#include "monitor/mcap/owned_message.h"

namespace galilean::mcap {

/// Finds the newest messages before an instant, and reads only the blocks that they stand in: what
/// holds at an instant of a long recording is known at once.
class NewestMessages {
 public:
  /// What is wanted of channels together: so many messages, and none before `since_ns` [ns since
  /// the Unix epoch].
  struct Wanted {
    std::vector<std::uint16_t> channels;
    std::size_t most = 1;
    std::uint64_t since_ns = 0;
  };
  struct Found {
    std::vector<OwnedMessage> messages;  ///< by log time; those of one time in the file's order
    std::vector<Damage> damages;         ///< of the blocks that were read
  };

  /// Requires: `source`, `blocks` and `channels`, which is of the same blocks, outlive this.
  NewestMessages(const ByteSource& source, const std::vector<Block>& blocks,
                 BlockChannels& channels);

  /// Returns the newest messages whose log time is before `before_ns`.
  /// Requires: no channel is wanted twice.
  [[nodiscard]] Found before(std::uint64_t before_ns, const std::vector<Wanted>& wanted);

 private:
  class Search;

  const std::vector<Block>& blocks_;
  BlockChannels& channels_;
  BlockLoader loader_;
  LoadedBlock loaded_;
  std::vector<std::uint32_t> order_;  ///< the blocks; that which ends last is first
};

}  // namespace galilean::mcap
