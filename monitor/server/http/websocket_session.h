// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <boost/asio/ip/tcp.hpp>
#include <memory>

#include "monitor/access/access.h"
#include "monitor/access/operator_id.h"
#include "monitor/server/foxglove/foxglove_hub.h"
#include "monitor/server/websocket/revocable.h"
#include "monitor/server/websocket/web_socket.h"

namespace galilean::monitor {

/// Serves one WebSocket of Foxglove's protocol until it closes. `right` decides whether the client
/// may call services, and `who` calls them. The session, which is returned, owns itself until then.
/// `hub` and `rounds` must outlive it.
std::weak_ptr<Revocable> serve_websocket(boost::asio::ip::tcp::socket socket,
                                         const WebSocket::Upgrade& upgrade, foxglove::Hub& hub,
                                         SendRounds& rounds, Right right, const OperatorId& who,
                                         std::shared_ptr<Connections::Place> place = nullptr);

}  // namespace galilean::monitor
