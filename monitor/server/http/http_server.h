// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/steady_timer.hpp>
#include <cstddef>
#include <cstdint>
#include <functional>
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
#include "monitor/server/http/turns.h"
#include "monitor/server/limits/connections.h"
#include "monitor/server/limits/descriptors.h"
#include "monitor/server/lsp/language_session.h"
#include "monitor/server/replay/replay_session.h"
#include "monitor/server/tls/tls_door.h"
#include "monitor/server/websocket/send_rounds.h"

namespace galilean::monitor {

/// Serves HTTP/1.1 on one address and port. GET /ws becomes a WebSocket of the hub, GET /lsp one of
/// the language server, GET /replay one of a recording. Everything runs on the io_context's one
/// thread. Connections, of which WebSockets are some, are limited in number, and requests in size
/// and in the time that they take to arrive. What clients ask for and may wait is done in Turns.
class HttpServer {
 public:
  struct Counts {
    std::size_t connections = 0;          ///< open HTTP connections
    std::size_t all_connections = 0;      ///< the same, and WebSockets
    std::uint64_t closed_for_others = 0;  ///< connections that were closed to make room
    std::uint64_t malformed = 0;          ///< requests that are no HTTP as RFC 9112 has it
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
    /// Returns how long a body may be that is sent to a path, of any method but PUT [bytes]; none:
    /// as long as a program.
    std::function<std::size_t(const std::string& path)> most_body_bytes = {};
    ServerLimits limits = {};
    Counts counts = {};
    GuessLimit guesses = {};
    OpenSockets sockets = {};
    SteadyClock clock = {};
    std::size_t bodies_bytes = 0;                    ///< of the long bodies that are kept now
    std::shared_ptr<LimitCounts> limit_counts = {};  ///< the server takes the hub's
    std::shared_ptr<Connections> connections = {};   ///< the server makes it
  };

  HttpServer(boost::asio::io_context& io, ServerContext context);
  ~HttpServer();
  HttpServer(const HttpServer&) = delete;
  HttpServer& operator=(const HttpServer&) = delete;

  /// Begins to accept connections. `address` is an IP address or "localhost"; port 0 takes any free
  /// port. Returns the port.
  /// Errors: `address` is not a valid address, or the port is taken or not permitted.
  [[nodiscard]] Result<std::uint16_t> listen(const std::string& address, std::uint16_t port);
  /// Lets connections in through `door`, which speaks TLS, from now on. Those that came through
  /// another one stay. Requires: `listen` was not called yet, or there was a door then.
  void use_tls(std::shared_ptr<TlsDoor> door);
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
  /// Makes a descriptor free after none was, and goes on after a pause.
  void recover();

  boost::asio::ip::tcp::acceptor acceptor_;
  boost::asio::steady_timer pause_;
  ReserveDescriptor reserve_;
  std::shared_ptr<ServerContext> context_;
  std::shared_ptr<Turns> turns_;
  std::shared_ptr<TlsDoor> tls_;  ///< null where plain HTTP is spoken
};

}  // namespace galilean::monitor
