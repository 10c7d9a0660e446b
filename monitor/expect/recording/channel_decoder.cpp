// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/expect/recording/channel_decoder.h"

#include "core/visible_text.h"
#include "core/wire/schemas.h"
#include "core/wire/types/own_types.h"
#include "monitor/replay/tracks.h"

namespace galilean::expect {

ChannelDecoders::ChannelDecoders(const mcap::Summary& summary, SampleSink& sink) : sink_(sink) {
  const auto tracks = monitor::tracks_of(summary);
  for (const auto& [id, channel] : summary.channels) {
    const auto schema = summary.schemas.find(channel.schema_id);
    const std::string type = schema == summary.schemas.end() ? "" : schema->second.name;
    add(channel, type, tracks.played.contains(id));
  }
}

void ChannelDecoders::add(const mcap::Channel& channel, const std::string& type, bool known) {
  Channel made{channel.topic, sink_.wants_messages(channel.topic), nullptr, std::nullopt};
  const auto choose = [&]<class Message>(const Message&) {
    if (type == Message::kRosType) made.decode = &ChannelDecoders::decode_as<Message>;
  };
  const bool typed = sink_.wants_type(type), fields = sink_.wants_fields(channel.topic);
  if (known && typed) {
    choose(msg::RobotState{});
    choose(msg::Transition{});
    choose(msg::Variables{});
    choose(msg::Score{});
    choose(msg::Program{});
  }
  const auto* schema = known && fields ? wire::find_schema_by_ros_type(type) : nullptr;
  const auto* own = schema ? wire::find_own_type(schema->dds_type) : nullptr;
  if (own) made.fields.emplace(own->description);
  if ((typed && !known) || (fields && !own))
    notes_.push_back(visible(channel.topic) + " is not decoded: this release defines " +
                     (type.empty() ? "its type" : visible(type)) + " otherwise or not at all");
  channels_.emplace(channel.id, std::move(made));
}

bool ChannelDecoders::take(std::int64_t at_ns, const mcap::Message& message) {
  const auto found = channels_.find(message.channel_id);
  if (found == channels_.end()) return false;
  Channel& channel = found->second;
  if (channel.counted) sink_.message(at_ns, channel.topic, message.sequence);
  const bool typed = !channel.decode || (this->*channel.decode)(at_ns, message);
  const bool fields = !channel.fields || decode_fields(channel, at_ns, message);
  return typed && fields;
}

template <class Message>
bool ChannelDecoders::decode_as(std::int64_t at_ns, const mcap::Message& message) {
  auto& decoded = std::get<Message>(scratch_);
  if (!msg::decode_cdr(message.data, decoded)) return false;
  sink_.sample(at_ns, decoded);
  return true;
}

bool ChannelDecoders::decode_fields(Channel& channel, std::int64_t at_ns,
                                    const mcap::Message& message) {
  const auto decoded = channel.fields->decode(message.data);
  if (!decoded) return false;
  sink_.fields(at_ns, channel.topic, decoded.value());
  return true;
}

std::string ChannelDecoders::topic(std::uint16_t channel) const {
  const auto found = channels_.find(channel);
  return found == channels_.end() ? "an unknown topic" : visible(found->second.topic);
}

}  // namespace galilean::expect
