// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/mcap/block_channels.h"

#include "monitor/mcap/message_indexes.h"
#include "monitor/mcap/unpack.h"

namespace galilean::mcap {

namespace {

/// Counts by channel, sorted, and without those that have no message.
BlockChannels::Counts sorted_counts(const std::map<std::uint16_t, std::uint32_t>& by_channel) {
  BlockChannels::Counts counts;
  counts.reserve(by_channel.size());
  for (const auto& [channel, messages] : by_channel)
    if (messages > 0) counts.push_back({channel, messages});
  return counts;
}

}  // namespace

const BlockChannels::Counts* BlockChannels::of(std::size_t block) {
  if (!asked_[block]) {
    asked_[block] = true;
    known_[block] = read(blocks_[block]);
  }
  return known_[block] ? &*known_[block] : nullptr;
}

void BlockChannels::learn(std::size_t block, const LoadedBlock& content) {
  std::map<std::uint16_t, std::uint32_t> by_channel;
  for (const auto& entry : content.entries) ++by_channel[entry.channel_id];
  asked_[block] = true;
  known_[block] = sorted_counts(by_channel);
}

std::optional<BlockChannels::Counts> BlockChannels::read(const Block& block) const {
  if (block.index_bytes == 0 || block.index_bytes > kMaxBlockBytes) return {};
  Bytes bytes(static_cast<std::size_t>(block.index_bytes));
  std::map<std::uint16_t, std::uint32_t> by_channel;
  const auto take = [&](const MessageIndex& index) {
    by_channel[index.channel_id] += static_cast<std::uint32_t>(index.entries.size());
  };
  if (!source_.read(block.index_offset, bytes) || !for_each_message_index(bytes, take)) return {};
  return sorted_counts(by_channel);
}

}  // namespace galilean::mcap
