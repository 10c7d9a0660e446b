// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/schemas/message_trees.h"

#include <string_view>
#include <utility>

#include "core/json_text.h"
#include "core/visible_text.h"
#include "core/wire/schemas.h"
#include "core/wire/types/own_types.h"
#include "monitor/schemas/ros2idl.h"
#include "monitor/schemas/ros2msg.h"

namespace galilean::monitor {
namespace {

constexpr std::size_t kLargestSchema = std::size_t{1} << 20;

Result<Definitions> definitions_in(const mcap::Schema& schema) {
  if (schema.data.size() > kLargestSchema) return Error{"is larger than 1 MiB"};
  if (schema.encoding == "ros2idl") return parse_ros2idl(schema.data);
  if (schema.encoding == "ros2msg") return parse_ros2msg(schema.name, schema.data);
  return Error{"is in the encoding '" + visible(schema.encoding) + "', which is not read here"};
}

}  // namespace

Result<wire::Type> type_of_schema(const mcap::Schema& schema) {
  const auto* ours = wire::find_schema_by_ros_type(schema.name);
  const auto* own =
      ours && ours->idl == schema.data ? wire::find_own_type(ours->dds_type) : nullptr;
  if (own) return own->description;
  const auto definitions = definitions_in(schema);
  if (!definitions) return Error{"has a schema that " + definitions.error().message};
  return make_type(definitions.value(), scoped_name(schema.name));
}

MessageTrees::MessageTrees(const mcap::Summary& summary) {
  for (const auto& [id, channel] : summary.channels)
    decoders_.emplace(id, decoder_of(channel, summary));
}

MessageTrees::Decoder MessageTrees::decoder_of(const mcap::Channel& channel,
                                               const mcap::Summary& summary) {
  const std::string topic = visible(channel.topic);
  if (channel.message_encoding == "json") return Json{};
  if (channel.message_encoding != "cdr")
    return Problem{"messages of " + topic + " are encoded as '" +
                   visible(channel.message_encoding) + "', which is not read here"};
  const auto schema = summary.schemas.find(channel.schema_id);
  if (schema == summary.schemas.end()) return Problem{"the recording has no schema for " + topic};
  auto type = type_of_schema(schema->second);
  if (!type)
    return Problem{"messages of " + topic + " are not decoded: their type, " +
                   visible(schema->second.name) + ", " + type.error().message};
  return MessageDecoder(std::move(type).value());
}

Result<MessageTree> MessageTrees::decode(const mcap::Message& message) const {
  const auto found = decoders_.find(message.channel_id);
  if (found == decoders_.end())
    return Error{"no record describes channel " + std::to_string(message.channel_id)};
  if (const auto* problem = std::get_if<Problem>(&found->second)) return Error{problem->sentence};
  if (const auto* decoder = std::get_if<MessageDecoder>(&found->second))
    return decoder->decode(message.data);
  const auto* text = reinterpret_cast<const char*>(message.data.data());
  const auto json = read_untrusted_json(std::string_view(text, message.data.size()));
  if (!json) return Error{"a message is no JSON: " + json.error().message};
  return MessageTree(json.value());
}

std::string MessageTrees::problem_of(std::uint16_t channel) const {
  const auto found = decoders_.find(channel);
  const auto* problem = found == decoders_.end() ? nullptr : std::get_if<Problem>(&found->second);
  return problem ? problem->sentence : std::string();
}

}  // namespace galilean::monitor
