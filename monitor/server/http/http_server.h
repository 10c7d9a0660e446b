// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "core/clock.h"
#include "core/result.h"
#include "monitor/access/guess_limit.h"
#include "monitor/server/foxglove/foxglove_hub.h"
#include "monitor/server/http/guard.h"
#include "monitor/server/http/http_messages.h"
#include "monitor/server/http/open_sockets.h"
#include "monitor/server/lsp/language_session.h"
#include "monitor/server/replay/replay_session.h"
#include "monitor/server/tls/tls_door.h"
#include "monitor/server/websocket/send_rounds.h"

namespace galilean::monitor {

/// Serves HTTP/1.1 on one address and port. GET /ws becomes a WebSocket of the hub, GET /lsp one of
/// the language server, GET /replay one of a recording. Everything runs on the io_context's one
/// thread. HTTP connections are limited in number, and requests in size and in the time that they
/// take to arrive; WebSockets do not count as HTTP connections.
class HttpServer {
 public:
  static constexpr std::size_t kMostConnections = 1024;

  struct Counts {
    std::size_t connections = 0;  ///< open HTTP connections
    std::uint64_t requests = 0;
    std::uint64_t refused = 0;       ///< requests that the guard refused
    std::size_t replays = 0;         ///< recordings that are played to a viewer now
    std::uint64_t wrong_tokens = 0;  ///< requests with a token that gives no right
    std::uint64_t held_off = 0;      ///< those of them that were told to wait
    std::uint64_t revoked = 0;       ///< WebSockets that were closed because their token ended
  };
  /// The objects that all sessions share. They live as long as the server or one of the sessions.
  struct ServerContext {
    Guard guard;
    Access access;
    HttpHandler handler;
    foxglove::Hub& hub;
    SendRounds& rounds;
    LanguageServerContext& language;
    ReplayContext& replay;
    Worker& transfers;  ///< reads files while they are sent
    Counts counts = {};
    GuessLimit guesses = {};
    OpenSockets sockets = {};
    SteadyClock clock = {};
  };

  HttpServer(boost::asio::io_context& io, ServerContext context);

  /// Begins to accept connections. `address` is an IP address or "localhost"; port 0 takes any free
  /// port. Returns the port.
  /// Errors: `address` is not a valid address, or the port is taken or not permitted.
  [[nodiscard]] Result<std::uint16_t> listen(const std::string& address, std::uint16_t port);
  /// Lets connections in through `door`, which speaks TLS. Requires: `listen` was not called yet.
  void use_tls(std::shared_ptr<TlsDoor> door) { tls_ = std::move(door); }
  /// Accepts no more connections. Those that are open stay.
  void close();
  [[nodiscard]] Counts counts() const;
  /// Replaces the named tokens.
  void set_named_tokens(std::vector<NamedToken> tokens);
  /// Ends the open WebSockets whose tokens were revoked or have expired. Call it twice a second or
  /// more often, because one that does not close by itself is cut at the next call.
  void end_withdrawn();

 private:
  void accept();
  void welcome(boost::asio::ip::tcp::socket socket);

  boost::asio::ip::tcp::acceptor acceptor_;
  std::shared_ptr<ServerContext> context_;
  std::shared_ptr<TlsDoor> tls_;  ///< null where plain HTTP is spoken
};

}  // namespace galilean::monitor
