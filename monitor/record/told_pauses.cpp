// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/record/told_pauses.h"

#include <algorithm>
#include <map>
#include <string>
#include <utility>

#include "monitor/mcap/message_reader.h"
#include "monitor/record/told_losses.h"

namespace galilean::monitor {
namespace {

using ByBeginning = std::map<std::int64_t, Pause>;

/// Takes in a pause; what tells its end knows more than what told its beginning.
void take_pause(std::optional<Pause> pause, ByBeginning& all) {
  if (!pause) return;
  auto& known = all[pause->from_ns];
  if (!known.to_ns) known = std::move(*pause);
}

bool is_pause_channel(const mcap::Summary& summary, std::uint16_t id) {
  const auto channel = summary.channels.find(id);
  return channel != summary.channels.end() && channel->second.topic == kPausesTopic;
}

bool has_pause_channel(const mcap::Summary& summary) {
  return std::ranges::any_of(
      summary.channels, [](const auto& channel) { return channel.second.topic == kPausesTopic; });
}

void read_messages(const mcap::ByteSource& source, const mcap::Summary& summary, ByBeginning& all) {
  mcap::MessageReader reader(source, summary.blocks);
  while (const mcap::Message* message = reader.next()) {
    if (!is_pause_channel(summary, message->channel_id)) continue;
    take_pause(read_pause(std::string(message->data.begin(), message->data.end())), all);
  }
}

bool lies_within(const Pause& pause, const mcap::Statistics& statistics) {
  if (statistics.messages == 0) return true;
  const auto from_ns = static_cast<std::uint64_t>(pause.from_ns);
  return from_ns <= statistics.end_ns &&
         (!pause.to_ns || static_cast<std::uint64_t>(*pause.to_ns) >= statistics.start_ns);
}

}  // namespace

std::vector<Pause> told_pauses(const mcap::ByteSource& source, const mcap::Summary& summary) {
  ByBeginning all;
  for (const auto& metadata : summary.metadata)
    if (metadata.name == kPausesMetadata)
      for (const auto& [number, text] : metadata.entries) take_pause(read_pause(text), all);
  if (has_pause_channel(summary) && !tells_its_end(summary)) read_messages(source, summary, all);
  std::vector<Pause> pauses;
  for (auto& [from_ns, pause] : all)
    if (lies_within(pause, summary.statistics)) pauses.push_back(std::move(pause));
  return pauses;
}

}  // namespace galilean::monitor
