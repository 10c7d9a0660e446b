// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "monitor/ingest/channel.h"

namespace galilean::monitor::foxglove {

/// The subprotocols that the server offers in Sec-WebSocket-Protocol. The messages below are the
/// same in both.
inline constexpr std::string_view kSubprotocols[] = {"foxglove.sdk.v1", "foxglove.websocket.v1"};

/// A service that clients call by name. Request and response are JSON.
struct Service {
  std::string name;               ///< "/galilean/push"
  std::string type;               ///< "galilean/Push"
  nlohmann::json request_schema;  ///< JSON Schema
  nlohmann::json response_schema;
};

/// A value that clients read, and may set, by name: "/io.held".
struct Parameter {
  std::string name;
  nlohmann::json value;
};
using ParameterValues = std::map<std::string, nlohmann::json>;

/// The ids of each topic's publishers and subscribers and of each service's providers. Topics have
/// their ROS names: "/io/state".
struct ConnectionGraph {
  using Ids = std::set<std::string>;
  std::map<std::string, Ids> published, subscribed, services;
  bool operator==(const ConnectionGraph&) const = default;
};

/// A channel as it is announced.
struct AdvertisedChannel {
  std::uint32_t id = 0;
  std::string topic;
  std::string encoding;  ///< of the messages
  std::string schema_name, schema_encoding, schema;
};

/// A recording as its viewers are told of it. Times are log times [ns since the Unix epoch].
struct RecordingInfo {
  std::string name;
  std::uint64_t start_ns = 0, end_ns = 0;
};

enum class StatusLevel { kInfo = 0, kWarning = 1, kError = 2 };

/// The server's JSON messages (ws-protocol, "JSON messages"), each as its text.
[[nodiscard]] std::string server_info(const std::string& name, const std::string& session_id);
/// Tells of a server whose time its clients control.
[[nodiscard]] std::string server_info(const RecordingInfo& recording,
                                      const std::string& session_id);
[[nodiscard]] std::string advertise(const std::vector<const Channel*>& channels);
[[nodiscard]] std::string advertise(const std::vector<AdvertisedChannel>& channels);
/// Gives the services the ids 1, 2, 3 … in their order.
[[nodiscard]] std::string advertise_services(const std::vector<Service>& services);
[[nodiscard]] std::string status(StatusLevel level, const std::string& message);
[[nodiscard]] std::string service_failure(std::uint32_t service_id, std::uint32_t call_id,
                                          const std::string& message);

/// `id` is the id of the request that this answers; empty for an update without a request.
[[nodiscard]] std::string parameter_values(const ParameterValues& values, const std::string& id);
/// Returns the message with the changes from `before` to `now`.
[[nodiscard]] std::string graph_update(const ConnectionGraph& before, const ConnectionGraph& now);

}  // namespace galilean::monitor::foxglove
