// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <sys/socket.h>
#include <unistd.h>

#include <cerrno>
#include <memory>
#include <string>
#include <string_view>
#include <utility>

#include "monitor/server/http/http_server.h"
#include "monitor/server/http/http_session.h"
#include "tests/fuzz/input.h"

namespace galilean::monitor {

/// The monitor's HTTP server without its port. A client's bytes come over a pair of local sockets,
/// so that nothing of a network is needed and each input has a connection of its own. Requests that
/// are no WebSocket go to `handler`. The token "operator" may steer, and reading is free.
class FuzzedServer {
 public:
  explicit FuzzedServer(HttpHandler handler)
      : context_(std::make_shared<HttpServer::ServerContext>(HttpServer::ServerContext{
            Guard("127.0.0.1", {}), Access({"viewer", "operator"}, true), std::move(handler), hub,
            rounds_, language_, replay_, worker_})) {
    context_->limit_counts = hub.limit_counts();
    context_->connections = std::make_shared<Connections>(context_->limits, context_->limit_counts);
  }
  ~FuzzedServer() {
    playbacks_.finish();
    worker_.finish();
  }
  FuzzedServer(const FuzzedServer&) = delete;
  FuzzedServer& operator=(const FuzzedServer&) = delete;

  /// Sends `first`, and once that is answered `rest`, and then nothing more. Returns all that comes
  /// back until the server has closed the connection. Requires: `first` has an answer.
  std::string exchange(std::string_view first, std::string_view rest) {
    return exchange_on(open(), first, rest);
  }
  /// Sends `all` at once, and then nothing more. Returns all that comes back.
  std::string exchange(std::string_view all) { return exchange_on(open(), {}, all); }

  foxglove::Hub hub{"monitor", [](std::uint32_t, bool) {}};

 private:
  /// Returns the client's end.
  int open() {
    int ends[2];
    bhdl::must(socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends) == 0, "there are sockets");
    boost::asio::ip::tcp::socket server(io_);
    boost::system::error_code failed;
    server.assign(boost::asio::ip::tcp::v4(), ends[0], failed);
    bhdl::must(!failed, "a socket can be served");
    auto place = context_->connections->admit("127.0.0.1", true);
    bhdl::must(place != nullptr, "a connection that is over leaves its place to the next one");
    serve_http(std::move(server), context_, "127.0.0.1", std::move(place));
    return ends[1];
  }

  std::string exchange_on(int client, std::string_view first, std::string_view rest) {
    std::string answer;
    if (!first.empty()) {
      send_all(client, first);
      while (answer.find("\r\n\r\n") == answer.npos && step(client, answer)) {
      }
    }
    send_all(client, rest);
    shutdown(client, SHUT_WR);
    while (step(client, answer)) {
    }
    close(client);
    // What the end of the connection sets going takes some turns.
    for (int turn = 0; turn < 10; ++turn) work();
    context_->sockets.end_withdrawn(context_->access);
    return answer;
  }

  static void send_all(int client, std::string_view bytes) {
    // The longest input is less than what such a socket keeps. The server may have closed it.
    const auto sent = send(client, bytes.data(), bytes.size(), MSG_NOSIGNAL);
    bhdl::must(sent == static_cast<ssize_t>(bytes.size()) || errno == EPIPE || errno == ECONNRESET,
               "a client can send");
  }

  void work() {
    io_.restart();
    io_.poll();
  }

  /// Lets the server work, and takes what it sent. Returns false once it has closed the connection.
  bool step(int client, std::string& answer) {
    work();
    char bytes[16 << 10];
    const auto count = recv(client, bytes, sizeof bytes, MSG_DONTWAIT);
    if (count > 0) answer.append(bytes, static_cast<std::size_t>(count));
    return count > 0 || (count < 0 && (errno == EAGAIN || errno == EINTR));
  }

  SteadyClock clock_;
  Team team_{clock_};
  const Catalog catalog_{};
  boost::asio::io_context io_{1};
  SendRounds rounds_{io_};
  Worker worker_{io_};
  LanguageServerContext language_{worker_, team_, catalog_, "/nonexistent"};
  RecordingFolder recordings_{"/nonexistent"};
  Playbacks playbacks_;
  ReplayContext replay_{recordings_, playbacks_};
  std::shared_ptr<HttpServer::ServerContext> context_;
};

}  // namespace galilean::monitor
