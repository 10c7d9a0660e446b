// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/mcap/losses.h"

#include <algorithm>

#include "core/plural.h"
#include "monitor/mcap/crc32.h"

namespace galilean::mcap {
namespace {

constexpr std::size_t kPieceBytes = std::size_t{1} << 20;

/// Returns the checksum of the first `end` bytes; nothing if they cannot be read.
std::optional<std::uint32_t> checksum_until(const ByteSource& source, std::uint64_t end) {
  Bytes piece;
  std::uint32_t sum = 0;
  for (std::uint64_t at = 0; at < end; at += piece.size()) {
    piece.resize(static_cast<std::size_t>(std::min<std::uint64_t>(kPieceBytes, end - at)));
    if (!source.read(at, piece)) return {};
    sum = crc32(piece, sum);
  }
  return sum;
}

std::map<std::uint16_t, std::uint64_t> missing(const Statistics& stated, const Statistics& read) {
  std::map<std::uint16_t, std::uint64_t> lost;
  for (const auto& [channel, messages] : stated.channel_messages) {
    const auto there = read.channel_messages.find(channel);
    const std::uint64_t found = there == read.channel_messages.end() ? 0 : there->second;
    if (messages > found) lost[channel] = messages - found;
  }
  return lost;
}

}  // namespace

void forgive_unfinished(const Survey& found, Summary& summary) {
  if (found.complete || found.damages.empty()) return;
  const std::uint64_t last = found.damages.back().offset;
  const bool something_follows =
      std::ranges::any_of(summary.blocks, [&](const Block& block) { return block.offset >= last; });
  if (!something_follows) summary.damages.pop_back();
}

void check_data_section(const ByteSource& source, const Survey& found, Summary& summary) {
  if (!found.complete || found.data_crc == 0 || !summary.damages.empty()) return;
  if (checksum_until(source, found.end) == found.data_crc) return;
  Damage damage{.what =
                    "the data section does not match its checksum, though every chunk matches its "
                    "own",
                .offset = found.end};
  // Messages in chunks have been compared; those outside chunks have no checksum of their own.
  if (std::ranges::all_of(summary.blocks, &Block::is_chunk)) damage.messages = 0;
  summary.damages.push_back(std::move(damage));
}

void name_nameless(Summary& summary) {
  for (const auto& [channel, messages] : summary.statistics.channel_messages)
    if (!summary.channels.contains(channel))
      summary.damages.push_back({.what = plural(messages, "message") + " of channel " +
                                         std::to_string(channel) + ", which no record describes",
                                 .offset = 0,
                                 .messages = 0});
}

void count_losses(const std::optional<Statistics>& stated, Summary& summary) {
  if (!summary.checked) return;
  if (stated) {
    summary.lost = missing(*stated, summary.statistics);
    if (!summary.lost.empty() && summary.damages.empty())
      summary.damages.push_back({.what = "the summary counts messages that are not there",
                                 .offset = 0,
                                 .messages = stated->messages - summary.statistics.messages,
                                 .channel_messages = summary.lost});
    return;
  }
  summary.lost_is_exact = summary.closed || summary.being_written;
  for (const auto& damage : summary.damages) {
    summary.lost_is_exact &= damage.messages.has_value();
    for (const auto& [channel, messages] : damage.channel_messages)
      summary.lost[channel] += messages;
  }
}

}  // namespace galilean::mcap
