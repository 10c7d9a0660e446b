// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/record/channels.h"

#include "core/visible_text.h"
#include "core/wire/schemas.h"
#include "core/wire/types/message_definition.h"
#include "core/wire/types/type_text.h"
#include "monitor/record/qos_profile.h"
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
  const auto [found, is_new] =
      channels_.try_emplace({end.topic, end.dds_type, end.type_hash, xcdr2});
  if (!is_new) return found->second;
  mcap::Channel channel;
  channel.schema_id = schema_of(end, xcdr2);
  channel.topic = shown_topic(end.topic);
  channel.message_encoding = "cdr";
  channel.metadata["offered_qos_profiles"] = offered_qos_profiles(end.qos);
  if (channel.schema_id == 0) channel.metadata["type"] = shown_type(end.dds_type);
  return found->second = writer_.add_channel(std::move(channel));
}

std::uint16_t Channels::schema_of(const wire::EndpointInfo& end, bool xcdr2) {
  const auto [found, is_new] = schemas_.try_emplace({end.dds_type, end.type_hash, xcdr2});
  if (!is_new) return found->second;
  auto [encoding, text] = schema_text(end, xcdr2);
  if (encoding.empty()) return 0;
  return found->second = writer_.add_schema(shown_type(end.dds_type), encoding, std::move(text));
}

/// Readers of the languages of ROS 2 decode XCDR1 alone.
Channels::Text Channels::schema_text(const wire::EndpointInfo& end, bool xcdr2) {
  const auto type = definitions_.find(end);
  if (!type) {
    warn_("'" + visible(shown_topic(end.topic)) +
          "' is recorded as bytes that no reader can decode: " + type.error().message);
    return {};
  }
  if (xcdr2) return {"omgidl", wire::type_text(type.value())};
  if (language_ == SchemaLanguage::kMessage)
    if (auto definition = wire::message_definition(type.value()))
      return {"ros2msg", std::move(definition).value()};
  const auto* own = wire::find_schema_by_dds_type(end.dds_type);
  if (own && definition_of(end) != Definition::kOther) return {"ros2idl", std::string(own->idl)};
  return {"omgidl", wire::type_text(type.value())};
}

}  // namespace galilean::monitor
