#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "monitor/ingest/channel.h"

namespace galilean::monitor::foxglove {

/// The subprotocols offered, as they stand in Sec-WebSocket-Protocol. Both speak what is here.
inline constexpr std::string_view kSubprotocols[] = {"foxglove.sdk.v1", "foxglove.websocket.v1"};

/// Something that clients may call by name, with JSON both ways.
struct Service {
  std::string name;               ///< "/galilean/push"
  std::string type;               ///< "galilean/Push"
  nlohmann::json request_schema;  ///< JSON Schema
  nlohmann::json response_schema;
};

enum class StatusLevel { kInfo = 0, kWarning = 1, kError = 2 };

/// The server's JSON messages (ws-protocol, "JSON messages"), each as its text.
[[nodiscard]] std::string server_info(const std::string& name, const std::string& session_id);
[[nodiscard]] std::string advertise(const std::vector<const Channel*>& channels);
/// Services get ids 1, 2, 3 … in their order.
[[nodiscard]] std::string advertise_services(const std::vector<Service>& services);
[[nodiscard]] std::string status(StatusLevel level, const std::string& message);
[[nodiscard]] std::string service_failure(std::uint32_t service_id, std::uint32_t call_id,
                                          const std::string& message);

}  // namespace galilean::monitor::foxglove
