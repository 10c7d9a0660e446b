// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/server/foxglove/subprotocol.h"

#include <boost/beast/http/field.hpp>
#include <boost/beast/http/rfc7230.hpp>

#include "monitor/server/foxglove/foxglove_messages.h"

namespace galilean::monitor::foxglove {

std::string_view subprotocol_for(const WebSocket::Upgrade& upgrade) {
  namespace http = boost::beast::http;
  http::token_list offered(upgrade[http::field::sec_websocket_protocol]);
  for (const auto ours : kSubprotocols)
    if (offered.exists({ours.data(), ours.size()})) return ours;
  return {};
}

}  // namespace galilean::monitor::foxglove
