// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/mcap/mcap_reader.h"

#include <algorithm>
#include <cctype>
#include <cstring>
#include <numeric>
#include <optional>
#include <span>
#include <utility>

#include "monitor/mcap/index_statistics.h"
#include "monitor/mcap/losses.h"
#include "monitor/mcap/message_reader.h"
#include "monitor/mcap/summary_section.h"

namespace galilean::mcap {
namespace {

std::uint64_t sum_of_counts(const std::map<std::uint16_t, std::uint64_t>& counts) {
  return std::accumulate(counts.begin(), counts.end(), std::uint64_t{0},
                         [](std::uint64_t sum, const auto& each) { return sum + each.second; });
}

/// Returns whether the statistics agree with what else is known, so that no message need be read to
/// count them.
bool agrees(const Statistics& statistics, const Summary& summary) {
  const auto chunks =
      std::ranges::count_if(summary.blocks, [](const Block& block) { return block.is_chunk; });
  return statistics.schemas == summary.schemas.size() &&
         statistics.channels == summary.channels.size() &&
         statistics.chunks == static_cast<std::size_t>(chunks) &&
         statistics.start_ns <= statistics.end_ns &&
         statistics.messages == sum_of_counts(statistics.channel_messages) &&
         std::ranges::all_of(statistics.channel_messages, [&](const auto& each) {
           return summary.channels.contains(each.first);
         });
}

void count(const Message& message, Statistics& statistics) {
  const bool first = statistics.messages++ == 0;
  ++statistics.channel_messages[message.channel_id];
  statistics.start_ns = first ? message.log_ns : std::min(statistics.start_ns, message.log_ns);
  statistics.end_ns = std::max(statistics.end_ns, message.log_ns);
}

/// Reads and counts all messages.
void count_all(const ByteSource& source, const Progress& progress, Summary& summary) {
  constexpr std::uint64_t kTellEach = 256;  // messages
  MessageReader reader(source, summary.blocks);
  RecordingTime time;
  while (const Message* message = reader.next()) {
    if (progress && summary.statistics.messages % kTellEach == 0) progress(reader.progress());
    time.move_to(message->log_ns);
    count(*message, summary.statistics);
  }
  summary.silences = time.silences();
  summary.schemas.insert(reader.schemas().begin(), reader.schemas().end());
  summary.channels.insert(reader.channels().begin(), reader.channels().end());
  summary.damages.insert(summary.damages.end(), reader.damages().begin(), reader.damages().end());
  summary.checked = true;
}

/// Takes over what was found, and returns the rest of it.
Survey take_over(Survey found, SummarySection& section, Summary& summary) {
  summary.header = std::move(found.header);
  summary.schemas = std::move(found.schemas);
  summary.channels = std::move(found.channels);
  summary.schemas.merge(section.schemas);
  summary.channels.merge(section.channels);
  summary.compressions = std::move(found.compressions);
  summary.metadata = std::move(found.metadata);
  summary.attachments = std::move(found.attachments);
  summary.blocks = std::move(found.blocks);
  summary.closed = section.closed;
  if (section.damage) summary.damages.push_back(*section.damage);
  summary.damages.insert(summary.damages.end(), found.damages.begin(), found.damages.end());
  return found;
}

/// Sets the numbers of the statistics that need no message to be read.
void count_records(Summary& summary) {
  Statistics& statistics = summary.statistics;
  statistics.schemas = static_cast<std::uint16_t>(summary.schemas.size());
  statistics.channels = static_cast<std::uint32_t>(summary.channels.size());
  statistics.metadata = static_cast<std::uint32_t>(summary.metadata.size());
  statistics.attachments = static_cast<std::uint32_t>(summary.attachments.size());
  statistics.chunks = static_cast<std::uint32_t>(
      std::ranges::count_if(summary.blocks, [](const Block& block) { return block.is_chunk; }));
}

bool has_right_statistics(const Summary& summary, const SummarySection& section) {
  return section.statistics && agrees(*section.statistics, summary);
}

bool is_to_be_read(const Summary& summary, const SummarySection& section, Depth depth) {
  if (depth == Depth::kIndexes) return false;
  const auto bytes = std::accumulate(
      summary.blocks.begin(), summary.blocks.end(), std::uint64_t{0},
      [](std::uint64_t sum, const Block& block) {
        return std::min(kCheckedBytes + 1,
                        sum + std::min(block.uncompressed_bytes, kCheckedBytes + 1));
      });
  return depth == Depth::kAll || bytes <= kCheckedBytes || !summary.damages.empty() ||
         !summary.closed || !has_right_statistics(summary, section);
}

/// Returns how many of the first bytes are not those of an MCAP file. Nothing: they are those of
/// something else. A damaged one has nearly all of them right, and its header behind them.
std::optional<std::size_t> differing_magic(const ByteSource& source) {
  constexpr std::size_t kMostDiffering = 2, kVersionAt = 5;
  std::uint8_t bytes[sizeof kMagic + kRecordHead];
  if (!source.read(0, std::span(bytes).first(sizeof kMagic))) return std::nullopt;
  std::size_t differing = 0;
  for (std::size_t i = 0; i < sizeof kMagic; ++i) differing += bytes[i] != kMagic[i] ? 1 : 0;
  if (differing == 0) return differing;
  const bool other_version = bytes[kVersionAt] != kMagic[kVersionAt] &&
                             std::isdigit(static_cast<unsigned char>(bytes[kVersionAt])) != 0;
  const bool has_header =
      source.read(0, bytes) && bytes[sizeof kMagic] == static_cast<std::uint8_t>(Opcode::kHeader);
  return differing > kMostDiffering || other_version || !has_header ? std::nullopt
                                                                    : std::optional(differing);
}

/// Returns the header; nothing if the first record is none.
std::optional<Header> read_header(const ByteSource& source) {
  constexpr std::uint64_t kMostBytes = std::uint64_t{1} << 20;
  std::uint8_t head[kRecordHead];
  if (!source.read(sizeof kMagic, head) || head[0] != static_cast<std::uint8_t>(Opcode::kHeader))
    return std::nullopt;
  std::uint64_t length = 0;
  std::memcpy(&length, head + 1, sizeof length);
  if (length > kMostBytes) return std::nullopt;
  Bytes content(static_cast<std::size_t>(length));
  Header header;
  if (!source.read(sizeof kMagic + kRecordHead, content) || !parse(content, header))
    return std::nullopt;
  return header;
}

}  // namespace

Result<void> check_format(const ByteSource& source) {
  if (source.size() == 0) return Error{"is empty: nothing was recorded"};
  if (!differing_magic(source)) return Error{"is not an MCAP file"};
  return {};
}

Result<void> check_header(const ByteSource& source) {
  if (const auto right = check_format(source); !right) return right.error();
  if (source.size() == sizeof kMagic)
    return Error{"ends behind the first bytes of an MCAP file: nothing was recorded"};
  if (!read_header(source))
    return Error{"has no header that can be read behind the first bytes, and is no recording"};
  return {};
}

Result<Summary> summarize(const ByteSource& source, Depth depth, const Progress& progress) {
  if (const auto right = check_format(source); !right) return right.error();
  const std::size_t differing = differing_magic(source).value_or(0);
  Summary summary;
  if (differing > 0)
    summary.damages.push_back(
        {.what = "the first bytes are not those of an MCAP file", .offset = 0, .messages = 0});
  summary.being_written = source.is_being_written();
  SummarySection section = read_summary_section(source);
  summary.bytes = source.size();
  auto known = section.checked ? std::move(section.chunks) : std::vector<ChunkIndex>{};
  const Survey found =
      take_over(survey(source, std::move(known), section.data_end), section, summary);
  if (!summary.closed && summary.being_written) forgive_unfinished(found, summary);
  if (is_to_be_read(summary, section, depth)) {
    count_all(source, progress, summary);
    check_data_section(source, found, summary);
  } else if (has_right_statistics(summary, section)) {
    summary.statistics = *section.statistics;
  } else {
    count_by_indexes(source, summary);
  }
  count_records(summary);
  name_nameless(summary);
  count_losses(section.statistics, summary);
  return summary;
}

}  // namespace galilean::mcap
