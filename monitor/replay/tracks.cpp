// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/replay/tracks.h"

#include <algorithm>
#include <array>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "core/wire/messages.h"
#include "core/wire/neighbours.h"
#include "core/wire/topic_names.h"
#include "monitor/playback/known_type.h"
#include "monitor/record/channel_metadata.h"
#include "monitor/record/losses.h"

namespace galilean::monitor {
namespace {

constexpr std::array<std::string_view, 4> kMadeByMonitor{
    wire::kObjectsTopic, wire::kMapTopic, wire::kMarkersTopic, wire::kPushProgressTopic};
constexpr std::array<std::string_view, 3> kShared{wire::kTfTopic, wire::kDiagnosticsTopic,
                                                  wire::kLogTopic};

bool is_known(const mcap::Channel& channel, const mcap::Schema& schema) {
  return channel.message_encoding == "cdr" && channel.topic.starts_with('/') &&
         known_type(schema) != nullptr;
}

/// What others recorded tells no sender: then a channel is one.
std::string sender_of(const mcap::Channel& channel) {
  const auto process = channel.metadata.find(kChannelProcess);
  return process != channel.metadata.end() ? process->second
                                           : "channel " + std::to_string(channel.id);
}

/// A topic has a channel for each of its writers.
void name_once(std::vector<std::string>& topics) {
  std::ranges::sort(topics);
  const auto rest = std::unique(topics.begin(), topics.end());
  topics.erase(rest, topics.end());
}

}  // namespace

Tracks tracks_of(const mcap::Summary& summary) {
  Tracks tracks;
  for (const auto& [id, channel] : summary.channels) {
    if (channel.topic == kLossesTopic) continue;  // the recorder's own
    const auto schema = summary.schemas.find(channel.schema_id);
    const std::string type = schema == summary.schemas.end() ? "" : schema->second.name;
    const auto delivery = wire::delivery_of(type);
    if (delivery == wire::Delivery::kCommand)
      tracks.commands.push_back(channel.topic);
    else if (schema != summary.schemas.end() && is_known(channel, schema->second))
      (delivery == wire::Delivery::kRecord ? tracks.inputs : tracks.played)[id] = {
          "rt" + channel.topic, type, delivery, sender_of(channel)};
    else
      tracks.foreign.push_back(channel.topic);
  }
  name_once(tracks.commands);
  name_once(tracks.foreign);
  return tracks;
}

std::set<std::string> robots_of(const Tracks& tracks) {
  std::set<std::string> robots;
  for (const auto& [id, track] : tracks.played)
    if (track.ros_type == msg::RobotState::kRosType) robots.insert(wire::owner_of(track.topic));
  return robots;
}

bool is_of(const Track& track, const std::string& robot) {
  return is_shared(track) ? track.sender == robot : wire::owner_of(track.topic) == robot;
}

void leave_out_clock(Tracks& tracks) {
  tracks.has_other_clock = std::erase_if(tracks.played, [](const auto& each) {
                             return each.second.topic == wire::kClockTopic;
                           }) > 0;
}

std::size_t topics_played(const Tracks& tracks) {
  std::set<std::string_view> topics;
  for (const auto& [id, track] : tracks.played) topics.insert(track.topic);
  return topics.size();
}

bool is_made_by_monitor(const Track& track) {
  return std::ranges::find(kMadeByMonitor, track.topic) != kMadeByMonitor.end();
}

bool is_shared(const Track& track) {
  return std::ranges::find(kShared, track.topic) != kShared.end();
}

}  // namespace galilean::monitor
