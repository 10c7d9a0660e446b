// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>

#include "core/result.h"
#include "monitor/server/foxglove/foxglove_hub.h"
#include "monitor/server/http/guard.h"
#include "monitor/server/http/http_messages.h"
#include "monitor/server/lsp/language_session.h"
#include "monitor/server/websocket/send_rounds.h"

namespace galilean::monitor {

/// Accepts HTTP/1.1 on one address and port; GET /ws becomes a WebSocket of the hub's,
/// GET /lsp one of the language server's. Everything
/// runs on the io_context's one thread. Connections are limited in number, requests in size and in
/// the time that they take.
class HttpServer {
 public:
  static constexpr std::size_t kMostConnections = 1024;

  struct Counts {
    std::size_t connections = 0;
    std::uint64_t requests = 0;
    std::uint64_t refused = 0;  ///< by the guard
  };
  /// What the sessions share; outlives the server as long as one of them lives.
  struct Site {
    Guard guard;
    Access access;
    HttpHandler handler;
    foxglove::Hub& hub;
    SendRounds& rounds;
    LanguageDesk& language;
    Counts counts = {};
  };

  HttpServer(boost::asio::io_context& io, Site site);

  /// `address` is a literal or "localhost"; port 0 takes any that is free.
  [[nodiscard]] Result<std::uint16_t> listen(const std::string& address, std::uint16_t port);
  void close();
  [[nodiscard]] const Counts& counts() const noexcept { return site_->counts; }

 private:
  void accept();

  boost::asio::ip::tcp::acceptor acceptor_;
  std::shared_ptr<Site> site_;
};

}  // namespace galilean::monitor
