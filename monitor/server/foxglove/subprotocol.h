// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string_view>

#include "monitor/server/websocket/web_socket.h"

namespace galilean::monitor::foxglove {

/// Says to a client what it should have offered.
inline constexpr const char* kNoSubprotocol =
    "offer the subprotocol foxglove.sdk.v1 or foxglove.websocket.v1";

/// Returns the first of kSubprotocols that the client offers, or an empty string.
[[nodiscard]] std::string_view subprotocol_for(const WebSocket::Upgrade& upgrade);

}  // namespace galilean::monitor::foxglove
