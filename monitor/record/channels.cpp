// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/record/channels.h"

#include "core/visible_text.h"
#include "core/wire/schemas.h"
#include "core/wire/types/message_definition.h"
#include "core/wire/types/type_text.h"
#include "monitor/record/qos_profile.h"
#include "monitor/wire/topic_name.h"

namespace galilean::monitor {

std::uint16_t Channels::of(const wire::EndpointInfo& end) {
  const auto [found, is_new] = channels_.try_emplace({end.topic, end.dds_type, end.type_hash});
  if (!is_new) return found->second;
  mcap::Channel channel;
  channel.schema_id = schema_of(end);
  channel.topic = shown_topic(end.topic);
  channel.message_encoding = "cdr";
  channel.metadata["offered_qos_profiles"] = offered_qos_profiles(end.qos);
  if (channel.schema_id == 0) channel.metadata["type"] = shown_type(end.dds_type);
  return found->second = writer_.add_channel(std::move(channel));
}

std::uint16_t Channels::schema_of(const wire::EndpointInfo& end) {
  const auto [found, is_new] = schemas_.try_emplace({end.dds_type, end.type_hash});
  if (!is_new) return found->second;
  auto [encoding, text] = schema_text(end);
  if (encoding.empty()) return 0;
  return found->second = writer_.add_schema(shown_type(end.dds_type), encoding, std::move(text));
}

Channels::Text Channels::schema_text(const wire::EndpointInfo& end) {
  const auto type = definitions_.find(end);
  if (!type) {
    warn_("'" + visible(shown_topic(end.topic)) +
          "' is recorded as bytes that no reader can decode: " + type.error().message);
    return {};
  }
  if (language_ == SchemaLanguage::kMessage)
    if (auto definition = wire::message_definition(type.value()))
      return {"ros2msg", std::move(definition).value()};
  const auto* own = wire::find_schema_by_dds_type(end.dds_type);
  if (own && definition_of(end) != Definition::kOther) return {"ros2idl", std::string(own->idl)};
  return {"omgidl", wire::type_text(type.value())};
}

}  // namespace galilean::monitor
