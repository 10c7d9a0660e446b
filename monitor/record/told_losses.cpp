// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/record/told_losses.h"

#include <algorithm>
#include <map>
#include <string>
#include <utility>

#include "core/visible_text.h"
#include "monitor/mcap/message_reader.h"

namespace galilean::monitor {
namespace {

using ByWriter = std::map<std::string, WriterLosses>;

auto count_metadata(const mcap::Summary& summary, std::string_view name) {
  return std::ranges::count(summary.metadata, name, &mcap::Metadata::name);
}

/// Returns how many of its writer's messages were accounted for. It grows while a recorder records.
std::uint64_t progress(const WriterLosses& losses) noexcept {
  return losses.recorded + losses.missing() + losses.left_out + losses.paused;
}

/// Keeps the newer of what is told of one writer.
void keep_newer(ByWriter& newest, WriterLosses losses) {
  const auto [known, is_new] = newest.try_emplace(losses.writer, losses);
  if (!is_new && progress(known->second) < progress(losses)) known->second = std::move(losses);
}

template <class Take>
void for_each_told(const mcap::Summary& summary, std::string_view name, const Take& take) {
  for (const auto& metadata : summary.metadata)
    if (metadata.name == name)
      for (const auto& [whose, text] : metadata.entries)
        if (auto losses = read_losses(text)) take(std::move(*losses));
}

/// Returns what was told at the end; of several files that were merged, at the end of the last.
ByWriter at_the_end(const mcap::Summary& summary) {
  ByWriter newest;
  for_each_told(summary, kLossesMetadata,
                [&](WriterLosses losses) { keep_newer(newest, std::move(losses)); });
  return newest;
}

/// Returns what had been told at the beginning; of several files that were merged, at that of the
/// first. A writer that one of them does not know has come later.
ByWriter before_the_beginning(const mcap::Summary& summary) {
  std::map<std::string, std::pair<std::ptrdiff_t, WriterLosses>> oldest;
  for_each_told(summary, kLossesBeforeMetadata, [&](WriterLosses losses) {
    auto& [times, known] = oldest[losses.writer];
    if (times++ == 0 || progress(losses) < progress(known)) known = std::move(losses);
  });
  const auto files = count_metadata(summary, kLossesBeforeMetadata);
  ByWriter before;
  for (auto& [writer, known] : oldest)
    if (known.first == files) before[writer] = std::move(known.second);
  return before;
}

/// Takes in what was told of each writer while it was recorded.
void take_in_what_was_told(const mcap::ByteSource& source, const mcap::Summary& summary,
                           ByWriter& newest) {
  mcap::MessageReader reader(source, summary.blocks);
  while (const mcap::Message* message = reader.next()) {
    const auto channel = summary.channels.find(message->channel_id);
    if (channel == summary.channels.end() || channel->second.topic != kLossesTopic) continue;
    const std::string text(message->data.begin(), message->data.end());
    if (auto losses = read_losses(text)) keep_newer(newest, std::move(*losses));
  }
}

bool says_nothing(const WriterLosses& losses) noexcept {
  return losses.lost == 0 &&
         losses.filled + losses.sent_before + losses.unwritten + losses.left_out + losses.paused ==
             0;
}

}  // namespace

std::uint64_t ToldLosses::missing() const noexcept {
  std::uint64_t sum = total_missing(writers);
  for (const auto& copy : copies) sum += copy.missing();
  return sum;
}

bool tells_its_end(const mcap::Summary& summary) {
  const auto ended = count_metadata(summary, kLossesMetadata);
  return ended > 0 && ended >= count_metadata(summary, kLossesBeforeMetadata);
}

std::optional<ToldLosses> told_losses(const mcap::ByteSource& source,
                                      const mcap::Summary& summary) {
  const auto ended = count_metadata(summary, kLossesMetadata);
  const bool is_ours = count_metadata(summary, kRecorderMetadata) > 0;
  auto copies = copy_losses(summary);
  if (ended == 0 && copies.empty() && (summary.closed || !is_ours)) return std::nullopt;
  ToldLosses told;
  const bool has_end = tells_its_end(summary);
  told.is_whole = has_end && std::ranges::all_of(copies, &CopyLosses::is_exact);
  told.copies = std::move(copies);
  auto newest = at_the_end(summary);
  if (!has_end) take_in_what_was_told(source, summary, newest);
  const auto before = before_the_beginning(summary);
  for (auto& [writer, losses] : newest) {
    const auto known = before.find(writer);
    if (known != before.end()) losses = beyond(std::move(losses), known->second);
    if (!says_nothing(losses)) told.writers.push_back(std::move(losses));
  }
  return told;
}

std::map<std::string, std::optional<std::uint64_t>> missing_by_topic(const ToldLosses& losses,
                                                                     const mcap::Summary& summary) {
  std::map<std::string, std::optional<std::uint64_t>> topics;
  if (losses.is_whole)
    for (const auto& [id, channel] : summary.channels) topics[visible(channel.topic)] = 0;
  for (const auto& each : losses.writers) {
    auto& missing = topics.try_emplace(each.topic, 0).first->second;
    if (missing && each.lost)
      *missing += each.missing();
    else
      missing = std::nullopt;
  }
  return topics;
}

}  // namespace galilean::monitor
