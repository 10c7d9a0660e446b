// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/record/channels.h"

#include "core/visible_text.h"
#include "core/wire/schemas.h"
#include "core/wire/types/message_definition.h"
#include "core/wire/types/type_text.h"
#include "monitor/record/qos_profile.h"
#include "monitor/record/selection.h"
#include "monitor/wire/topic_name.h"

namespace galilean::monitor {
namespace {

/// The first two bytes of a message say how it is encoded (DDS-XTypes 1.3, 7.6.3.1.2).
bool is_xcdr2(std::span<const std::uint8_t> cdr) {
  constexpr int kFirstOfXcdr2 = 6;
  return cdr.size() >= 2 && (cdr[0] << 8 | cdr[1]) >= kFirstOfXcdr2;
}

}  // namespace

std::uint16_t Channels::of(const wire::EndpointInfo& end, std::span<const std::uint8_t> cdr) {
  const bool xcdr2 = is_xcdr2(cdr);
  const auto known = channels_.find({end.guid, xcdr2});
  if (known != channels_.end()) return known->second;
  if (of_one_writer_ < kMostOfOneWriter) {
    ++of_one_writer_;
    return channels_[{end.guid, xcdr2}] = add(end, xcdr2, false);
  }
  auto& shared = shared_[{end.topic, end.dds_type, end.type_hash, xcdr2}];
  return shared != 0 ? shared : shared = add(end, xcdr2, true);
}

void Channels::begin_part() {
  ++part_;
  channels_.clear();
}

std::uint16_t Channels::add(const wire::EndpointInfo& end, bool xcdr2, bool shared) {
  mcap::Channel channel;
  channel.schema_id = schema_of(end, xcdr2);
  channel.topic = shown_topic(end.topic);
  channel.message_encoding = "cdr";
  channel.metadata["offered_qos_profiles"] = offered_qos_profiles(end.qos);
  if (channel.schema_id == 0) channel.metadata["type"] = shown_type(end.dds_type);
  if (!shared) {
    channel.metadata[kChannelWriter] = end.guid;
    channel.metadata[kChannelProcess] = end.process;
    if (part_ > 1) channel.metadata[kChannelPart] = std::to_string(part_);
  }
  if (auto why = sequence_gaps(end, shared); !why.empty())
    channel.metadata[kSequenceGaps] = std::move(why);
  return setup_.writer.add_channel(std::move(channel));
}

/// Returns an empty text if gaps in the numbers of a channel are missing messages.
std::string Channels::sequence_gaps(const wire::EndpointInfo& end, bool shared) const {
  if (shared) return "several writers number their messages";
  if (end.keyed) return "what ends a key has a number, and is no message";
  if (setup_.leaves_out_pictures && is_picture(end)) return "pictures beyond a limit are left out";
  return {};
}

std::uint16_t Channels::schema_of(const wire::EndpointInfo& end, bool xcdr2) {
  const auto [found, is_new] = schemas_.try_emplace({end.dds_type, end.type_hash, xcdr2});
  if (!is_new) return found->second;
  auto [encoding, text] = schema_text(end, xcdr2);
  if (encoding.empty()) return 0;
  return found->second =
             setup_.writer.add_schema(shown_type(end.dds_type), encoding, std::move(text));
}

/// Readers of the languages of ROS 2 decode XCDR1 alone.
Channels::Text Channels::schema_text(const wire::EndpointInfo& end, bool xcdr2) {
  const auto type = setup_.definitions.find(end);
  if (!type) {
    setup_.warn("'" + visible(shown_topic(end.topic)) +
                "' is recorded as bytes that no reader can decode: " + type.error().message);
    return {};
  }
  if (xcdr2) return {"omgidl", wire::type_text(type.value())};
  if (setup_.language == SchemaLanguage::kMessage)
    if (auto definition = wire::message_definition(type.value()))
      return {"ros2msg", std::move(definition).value()};
  const auto* own = wire::find_schema_by_dds_type(end.dds_type);
  if (own && definition_of(end) != Definition::kOther) return {"ros2idl", std::string(own->idl)};
  return {"omgidl", wire::type_text(type.value())};
}

}  // namespace galilean::monitor
