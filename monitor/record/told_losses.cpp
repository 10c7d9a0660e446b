// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/record/told_losses.h"

#include <algorithm>
#include <map>
#include <string>

#include "monitor/mcap/message_reader.h"

namespace galilean::monitor {
namespace {

constexpr const char* kRecorderMetadata = "galilean";

const mcap::Metadata* find_metadata(const mcap::Summary& summary, std::string_view name) {
  const auto found = std::ranges::find(summary.metadata, name, &mcap::Metadata::name);
  return found == summary.metadata.end() ? nullptr : &*found;
}

std::vector<WriterLosses> at_the_end(const mcap::Metadata& metadata) {
  std::vector<WriterLosses> writers;
  for (const auto& [name, text] : metadata.entries)
    if (auto losses = read_losses(text)) writers.push_back(std::move(*losses));
  return writers;
}

/// Returns the newest that was told of each writer.
std::vector<WriterLosses> on_the_way(const mcap::ByteSource& source, const mcap::Summary& summary) {
  std::map<std::string, WriterLosses> newest;
  mcap::MessageReader reader(source, summary.blocks);
  while (const mcap::Message* message = reader.next()) {
    const auto channel = summary.channels.find(message->channel_id);
    if (channel == summary.channels.end() || channel->second.topic != kLossesTopic) continue;
    const std::string text(message->data.begin(), message->data.end());
    if (auto losses = read_losses(text)) newest[losses->writer] = std::move(*losses);
  }
  std::vector<WriterLosses> writers;
  for (auto& [writer, losses] : newest) writers.push_back(std::move(losses));
  return writers;
}

}  // namespace

std::optional<ToldLosses> told_losses(const mcap::ByteSource& source,
                                      const mcap::Summary& summary) {
  if (const auto* metadata = find_metadata(summary, kLossesMetadata))
    return ToldLosses{at_the_end(*metadata), true};
  if (!summary.recovered() || !find_metadata(summary, kRecorderMetadata)) return std::nullopt;
  return ToldLosses{on_the_way(source, summary), false};
}

}  // namespace galilean::monitor
