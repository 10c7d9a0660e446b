// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/mcap/index_statistics.h"

#include <algorithm>

#include "monitor/mcap/block_channels.h"

namespace galilean::mcap {
namespace {

bool describes_all(const Summary& summary, const BlockChannels::Counts& counts) {
  return std::ranges::all_of(
      counts, [&](const auto& each) { return summary.channels.contains(each.channel_id); });
}

/// Takes the records of a block that describe channels. A record outside of blocks goes before.
void take_descriptions(const LoadedBlock& content, Summary& summary) {
  for (const auto& schema : content.schemas) summary.schemas.insert({schema.id, schema});
  for (const auto& channel : content.channels) summary.channels.insert({channel.id, channel});
  if (content.damage) summary.damages.push_back(*content.damage);
}

void widen_times(const Block& block, Statistics& statistics, bool is_first) {
  statistics.start_ns = is_first ? block.start_ns : std::min(statistics.start_ns, block.start_ns);
  statistics.end_ns = std::max(statistics.end_ns, block.end_ns);
}

}  // namespace

void count_by_indexes(const ByteSource& source, Summary& summary) {
  BlockChannels channels(source, summary.blocks);
  BlockLoader loader(source);
  LoadedBlock content;
  Statistics& statistics = summary.statistics;
  for (std::size_t i = 0; i < summary.blocks.size(); ++i) {
    const auto* counts = channels.of(i);
    if (!counts || !describes_all(summary, *counts)) {
      loader.load(summary.blocks[i], content);
      channels.learn(i, content);
      take_descriptions(content, summary);
      counts = channels.of(i);
    }
    if (counts->empty()) continue;
    widen_times(summary.blocks[i], statistics, statistics.messages == 0);
    for (const auto [channel, messages] : *counts) {
      statistics.channel_messages[channel] += messages;
      statistics.messages += messages;
    }
  }
}

}  // namespace galilean::mcap
