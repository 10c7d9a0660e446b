// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/playback/recorded_topics.h"

#include <set>
#include <string_view>
#include <tuple>

#include "core/wire/messages.h"
#include "monitor/playback/known_type.h"

namespace galilean::monitor {
namespace {

/// Returns whether the channel's writer kept messages for late joiners, as ROS 2's metadata says
/// it: in words, or as the number of the enumeration.
bool was_kept_for_late_joiners(const mcap::Channel& channel) {
  const auto offered = channel.metadata.find("offered_qos_profiles");
  return offered != channel.metadata.end() &&
         (offered->second.find("durability: transient_local") != std::string::npos ||
          offered->second.find("durability: 1\n") != std::string::npos);
}

RecordedTopic topic_without_channels(const mcap::Channel& channel, const mcap::Schema& schema) {
  RecordedTopic topic{.topic = channel.topic,
                      .encoding = channel.message_encoding,
                      .schema_name = schema.name,
                      .schema_encoding = schema.encoding,
                      .schema = schema.data,
                      .delivery = wire::delivery_of(schema.name)};
  if (const auto* known = channel.message_encoding == "cdr" ? known_type(schema) : nullptr) {
    topic.schema_encoding = "ros2idl";
    topic.schema = known->idl;
  } else if (topic.delivery == wire::Delivery::kStream && was_kept_for_late_joiners(channel)) {
    topic.delivery = wire::Delivery::kState;
  }
  return topic;
}

auto likeness(const RecordedTopic& topic) {
  return std::tie(topic.topic, topic.encoding, topic.schema_name, topic.schema_encoding,
                  topic.schema, topic.delivery);
}

struct Unlike {
  bool operator()(const RecordedTopic& a, const RecordedTopic& b) const {
    return likeness(a) < likeness(b);
  }
};

}  // namespace

std::vector<RecordedTopic> recorded_topics(const mcap::Summary& summary) {
  std::map<RecordedTopic, std::vector<std::uint16_t>, Unlike> alike;
  for (const auto& [id, channel] : summary.channels) {
    const auto schema = summary.schemas.find(channel.schema_id);
    alike[topic_without_channels(channel,
                                 schema == summary.schemas.end() ? mcap::Schema{} : schema->second)]
        .push_back(id);
  }
  std::vector<RecordedTopic> topics;
  for (const auto& [topic, channels] : alike) {
    topics.push_back(topic);
    topics.back().id = static_cast<std::uint32_t>(topics.size());
    topics.back().channels = channels;
  }
  return topics;
}

std::vector<std::string> recorded_robots(const std::map<std::uint16_t, mcap::Schema>& schemas,
                                         const std::map<std::uint16_t, mcap::Channel>& channels) {
  constexpr std::string_view kEnd = "/state";
  std::set<std::string> names;
  for (const auto& [id, channel] : channels) {
    const auto schema = schemas.find(channel.schema_id);
    if (schema == schemas.end() || schema->second.name != msg::RobotState::kRosType) continue;
    if (!channel.topic.starts_with('/') || !channel.topic.ends_with(kEnd)) continue;
    names.insert(channel.topic.substr(1, channel.topic.size() - 1 - kEnd.size()));
  }
  return {names.begin(), names.end()};
}

}  // namespace galilean::monitor
