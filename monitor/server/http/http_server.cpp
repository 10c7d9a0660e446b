// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/server/http/http_server.h"

#include <boost/asio/steady_timer.hpp>

#include "monitor/background/guarded.h"
#include "monitor/server/http/http_session.h"

namespace galilean::monitor {
namespace {
using boost::asio::ip::tcp;
using error_code = boost::system::error_code;
}  // namespace

HttpServer::HttpServer(boost::asio::io_context& io, ServerContext context)
    : acceptor_(io), context_(std::make_shared<ServerContext>(std::move(context))) {}

Result<std::uint16_t> HttpServer::listen(const std::string& address, std::uint16_t port) {
  error_code error;
  const auto literal =
      boost::asio::ip::make_address(address == "localhost" ? "127.0.0.1" : address, error);
  if (error)
    return Error{"'" + address + "' is not a valid address to listen on, such as 127.0.0.1"};
  const tcp::endpoint endpoint(literal, port);
  acceptor_.open(endpoint.protocol(), error);
  if (!error) acceptor_.set_option(tcp::acceptor::reuse_address(true), error);
  if (!error) acceptor_.bind(endpoint, error);
  if (!error) acceptor_.listen(boost::asio::socket_base::max_listen_connections, error);
  if (error) {
    const auto where = address + ":" + std::to_string(port);
    if (error == boost::asio::error::address_in_use)
      return Error{"another program listens on " + where +
                   " already; end it, or choose another port with --listen"};
    return Error{"cannot listen on " + where + ": " + error.message()};
  }
  accept();
  return acceptor_.local_endpoint().port();
}

void HttpServer::close() {
  error_code ignored;
  acceptor_.close(ignored);
}

HttpServer::Counts HttpServer::counts() const {
  Counts counts = context_->counts;
  counts.replays = context_->replay.playbacks.running();
  counts.revoked = context_->sockets.ended();
  return counts;
}

void HttpServer::set_named_tokens(std::vector<NamedToken> tokens) {
  context_->access.set_named(std::move(tokens));
}

void HttpServer::end_withdrawn() {
  context_->sockets.end_withdrawn(context_->access);
}

void HttpServer::welcome(tcp::socket socket) {
  if (tls_)
    return tls_->enter(std::move(socket),
                       [context = context_](tcp::socket inner, const std::string& address) {
                         if (context->counts.connections < kMostConnections)
                           serve_http(std::move(inner), context, address);
                       });
  error_code ignored;
  const auto address = socket.remote_endpoint(ignored).address().to_string();
  serve_http(std::move(socket), context_, address);
}

void HttpServer::accept() {
  acceptor_.async_accept([this](error_code error, tcp::socket socket) {
    if (error == boost::asio::error::operation_aborted) return;
    if (error) {  // mostly because no file descriptor is free; so wait until one is
      auto pause = std::make_shared<boost::asio::steady_timer>(acceptor_.get_executor(),
                                                               std::chrono::milliseconds(100));
      pause->async_wait([this, pause](error_code) {
        if (acceptor_.is_open()) accept();
      });
      return;
    }
    if (context_->counts.connections < kMostConnections)
      (void)guarded("a new connection", [&] { welcome(std::move(socket)); });
    accept();
  });
}

}  // namespace galilean::monitor
