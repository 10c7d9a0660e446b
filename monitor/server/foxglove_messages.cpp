#include "monitor/server/foxglove_messages.h"

#include "monitor/server/json_text.h"

namespace galilean::monitor::foxglove {
namespace {

nlohmann::json definition(const nlohmann::json& schema, const std::string& name) {
  return {{"encoding", "json"},
          {"schemaName", name},
          {"schemaEncoding", "jsonschema"},
          {"schema", schema.dump()}};
}

}  // namespace

std::string server_info(const std::string& name, const std::string& session_id) {
  return json_text({{"op", "serverInfo"},
                    {"name", name},
                    {"capabilities", {"services", "time"}},
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
                    {"response", definition(service.response_schema, service.type + "_Response")},
                    {"requestSchema", service.request_schema.dump()},
                    {"responseSchema", service.response_schema.dump()}});
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

}  // namespace galilean::monitor::foxglove
