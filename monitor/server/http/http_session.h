// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "monitor/server/http/http_server.h"

namespace galilean::monitor {

/// Serves one connection, which has `place` among all, until it closes or becomes a WebSocket. The
/// session owns itself until then. `address` is the client's.
void serve_http(boost::asio::ip::tcp::socket socket,
                std::shared_ptr<HttpServer::ServerContext> context, std::string address,
                std::shared_ptr<Connections::Place> place);

}  // namespace galilean::monitor
