// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/expect/recording/channel_decoder.h"

#include <algorithm>
#include <utility>

#include "core/visible_text.h"
#include "monitor/record/channel_metadata.h"
#include "monitor/replay/tracks.h"
#include "monitor/schemas/message_trees.h"

namespace galilean::expect {

ChannelDecoders::ChannelDecoders(const mcap::Summary& summary, SampleSink& sink)
    : sink_(sink), typed_(sink) {
  const auto tracks = monitor::tracks_of(summary);
  for (const auto& [id, channel] : summary.channels) {
    const auto schema = summary.schemas.find(channel.schema_id);
    add(channel, schema == summary.schemas.end() ? mcap::Schema{} : schema->second,
        tracks.played.contains(id));
  }
}

void ChannelDecoders::add(const mcap::Channel& channel, const mcap::Schema& schema, bool known) {
  Channel made{channel.topic, sink_.wants_messages(channel.topic),
               !channel.metadata.contains(monitor::kSequenceGaps), nullptr, std::nullopt};
  const bool typed = sink_.wants_type(schema.name);
  if (typed && known) made.decode = TypedDecoder::function_for(schema.name);
  if (typed && !known)
    note(visible(channel.topic) + " is not decoded: this release defines " + visible(schema.name) +
         " otherwise or not at all");
  if (sink_.wants_fields(channel.topic)) add_fields(channel, schema, made);
  channels_.emplace(channel.id, std::move(made));
}

void ChannelDecoders::add_fields(const mcap::Channel& channel, const mcap::Schema& schema,
                                 Channel& to) {
  auto type = channel.message_encoding == "cdr"
                  ? monitor::type_of_schema(schema)
                  : Result<wire::Type>(Error{"is not encoded as CDR"});
  if (type)
    to.fields.emplace(std::move(type).value());
  else
    note("fields of " + visible(channel.topic) + " are not decoded: its type, " +
         visible(schema.name) + ", " + type.error().message);
}

/// A topic has a channel for each of its writers.
void ChannelDecoders::note(std::string sentence) {
  if (std::ranges::find(notes_, sentence) == notes_.end()) notes_.push_back(std::move(sentence));
}

bool ChannelDecoders::take(std::int64_t at_ns, const mcap::Message& message) {
  const auto found = channels_.find(message.channel_id);
  if (found == channels_.end()) return false;
  Channel& channel = found->second;
  if (channel.counted)
    sink_.message(at_ns, channel.topic,
                  {message.channel_id, channel.numbered ? message.sequence : 0});
  const bool typed = !channel.decode || (typed_.*channel.decode)(at_ns, message.data);
  const bool fields = !channel.fields || decode_fields(channel, at_ns, message);
  return typed && fields;
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
