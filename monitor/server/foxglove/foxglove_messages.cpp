// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/server/foxglove/foxglove_messages.h"

#include <algorithm>
#include <iterator>

#include "core/json_text.h"

namespace galilean::monitor::foxglove {
namespace {

nlohmann::json definition(const nlohmann::json& schema, const std::string& name) {
  return {{"encoding", "json"},
          {"schemaName", name},
          {"schemaEncoding", "jsonschema"},
          {"schema", json_text(schema)}};
}

nlohmann::json time_json(std::uint64_t since_epoch_ns) {
  constexpr std::uint64_t kSecond_ns = 1'000'000'000;
  return {{"sec", since_epoch_ns / kSecond_ns}, {"nsec", since_epoch_ns % kSecond_ns}};
}

std::string base64(std::string_view bytes) {
  static constexpr char kDigits[] =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  for (std::size_t at = 0; at < bytes.size(); at += 3) {
    const auto part = bytes.substr(at, 3);
    std::uint32_t bits = 0;
    for (std::size_t i = 0; i < 3; ++i)
      bits = bits << 8 | (i < part.size() ? static_cast<std::uint8_t>(part[i]) : 0u);
    for (std::size_t i = 0; i < 4; ++i)
      text += i <= part.size() ? kDigits[bits >> (18 - 6 * i) & 63] : '=';
  }
  return text;
}

/// The protocol wants schemas that are no text in base 64.
std::string schema_text(const AdvertisedChannel& channel) {
  const bool is_binary =
      channel.schema_encoding == "protobuf" || channel.schema_encoding == "flatbuffer";
  return is_binary ? base64(channel.schema) : channel.schema;
}

using Ends = std::map<std::string, ConnectionGraph::Ids>;

/// Returns the topics or services whose ends changed, each as {name, `ids`: […]}.
nlohmann::json changed(const Ends& before, const Ends& now, const char* ids) {
  auto list = nlohmann::json::array();
  for (const auto& [name, ends] : now)
    if (const auto found = before.find(name); found == before.end() || found->second != ends)
      list.push_back({{"name", name}, {ids, ends}});
  for (const auto& [name, ends] : before)
    if (!now.contains(name)) list.push_back({{"name", name}, {ids, nlohmann::json::array()}});
  return list;
}

std::set<std::string> names(const Ends& first, const Ends& second = {}) {
  std::set<std::string> all;
  for (const auto* each : {&first, &second})
    for (const auto& [name, ends] : *each) all.insert(name);
  return all;
}

std::vector<std::string> gone(const std::set<std::string>& before,
                              const std::set<std::string>& now) {
  std::vector<std::string> list;
  std::ranges::set_difference(before, now, std::back_inserter(list));
  return list;
}

}  // namespace

std::string server_info(const std::string& name, const std::string& session_id) {
  return json_text({{"op", "serverInfo"},
                    {"name", name},
                    {"capabilities",
                     {"services", "time", "parameters", "parametersSubscribe", "connectionGraph"}},
                    {"supportedEncodings", {"json"}},
                    {"metadata", {{"product", "galilean"}}},
                    {"sessionId", session_id}});
}

std::string server_info(const RecordingInfo& recording, const std::string& session_id) {
  return json_text({{"op", "serverInfo"},
                    {"name", recording.name},
                    {"capabilities", {"time", "playbackControl"}},
                    {"supportedEncodings", nlohmann::json::array()},
                    {"metadata", {{"product", "galilean"}}},
                    {"sessionId", session_id},
                    {"dataStartTime", time_json(recording.start_ns)},
                    {"dataEndTime", time_json(recording.end_ns)}});
}

std::string advertise(const std::vector<AdvertisedChannel>& channels) {
  auto list = nlohmann::json::array();
  for (const auto& channel : channels)
    list.push_back({{"id", channel.id},
                    {"topic", channel.topic},
                    {"encoding", channel.encoding},
                    {"schemaName", channel.schema_name},
                    {"schema", schema_text(channel)},
                    {"schemaEncoding", channel.schema_encoding}});
  return json_text({{"op", "advertise"}, {"channels", std::move(list)}});
}

std::string advertise(const std::vector<const Channel*>& channels) {
  std::vector<AdvertisedChannel> list;
  for (const Channel* channel : channels)
    list.push_back({.id = channel->id,
                    .topic = channel->ros_name(),
                    .encoding = "cdr",
                    .schema_name = std::string(channel->schema->ros_type),
                    .schema_encoding = "ros2idl",
                    .schema = std::string(channel->schema->idl)});
  return advertise(list);
}

std::string advertise_services(const std::vector<Service>& services) {
  auto list = nlohmann::json::array();
  for (const auto& service : services)
    list.push_back({{"id", list.size() + 1},
                    {"name", service.name},
                    {"type", service.type},
                    {"request", definition(service.request_schema, service.type + "_Request")},
                    {"response", definition(service.response_schema, service.type + "_Response")}});
  return json_text({{"op", "advertiseServices"}, {"services", std::move(list)}});
}

std::string status(StatusLevel level, const std::string& message) {
  return json_text({{"op", "status"}, {"level", static_cast<int>(level)}, {"message", message}});
}

std::string service_failure(std::uint32_t service_id, std::uint32_t call_id,
                            const std::string& message) {
  return json_text({{"op", "serviceCallFailure"},
                    {"serviceId", service_id},
                    {"callId", call_id},
                    {"message", message}});
}

std::string parameter_values(const ParameterValues& values, const std::string& id) {
  auto list = nlohmann::json::array();
  for (const auto& [name, value] : values) list.push_back({{"name", name}, {"value", value}});
  nlohmann::json message{{"op", "parameterValues"}, {"parameters", std::move(list)}};
  if (!id.empty()) message["id"] = id;
  return json_text(message);
}

std::string graph_update(const ConnectionGraph& before, const ConnectionGraph& now) {
  return json_text(
      {{"op", "connectionGraphUpdate"},
       {"publishedTopics", changed(before.published, now.published, "publisherIds")},
       {"subscribedTopics", changed(before.subscribed, now.subscribed, "subscriberIds")},
       {"advertisedServices", changed(before.services, now.services, "providerIds")},
       {"removedTopics",
        gone(names(before.published, before.subscribed), names(now.published, now.subscribed))},
       {"removedServices", gone(names(before.services), names(now.services))}});
}

}  // namespace galilean::monitor::foxglove
