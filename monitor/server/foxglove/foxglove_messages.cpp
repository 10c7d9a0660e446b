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

std::string advertise(const std::vector<const Channel*>& channels) {
  auto list = nlohmann::json::array();
  for (const Channel* channel : channels)
    list.push_back({{"id", channel->id},
                    {"topic", channel->ros_name()},
                    {"encoding", "cdr"},
                    {"schemaName", channel->schema->ros_type},
                    {"schema", channel->schema->idl},
                    {"schemaEncoding", "ros2idl"}});
  return json_text({{"op", "advertise"}, {"channels", std::move(list)}});
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
