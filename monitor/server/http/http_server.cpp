// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/server/http/http_server.h"

#include <chrono>
#include <utility>

#include "monitor/background/guarded.h"
#include "monitor/server/http/http_session.h"

namespace galilean::monitor {
namespace {
using boost::asio::ip::tcp;
using error_code = boost::system::error_code;

constexpr auto kPauseWithoutDescriptors = std::chrono::milliseconds(100);
}  // namespace

HttpServer::HttpServer(boost::asio::io_context& io, ServerContext context)
    : acceptor_(io),
      pause_(io),
      context_(std::make_shared<ServerContext>(std::move(context))),
      turns_(std::make_shared<Turns>(io, context_->clock)) {
  context_->limit_counts = context_->hub.limit_counts();
  context_->connections = std::make_shared<Connections>(context_->limits, context_->limit_counts);
  context_->connections->take_turns_by(
      [turns = turns_](std::function<void()> work) { turns->take(std::move(work)); });
}

HttpServer::~HttpServer() {
  turns_->end();
}

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

void HttpServer::use_tls(std::shared_ptr<TlsDoor> door) {
  tls_ = std::move(door);
  context_->guard.answer_also_for(
      [door = tls_](const std::string& name) { return door->is_named(name); });
}

void HttpServer::close() {
  error_code ignored;
  acceptor_.close(ignored);
}

HttpServer::Counts HttpServer::counts() const {
  Counts counts = context_->counts;
  counts.all_connections = context_->connections->open();
  counts.closed_for_others = context_->connections->closed_for_others();
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

/// A connection has its place before it speaks TLS, so that those who only shake hands count, too.
void HttpServer::welcome(tcp::socket socket) {
  error_code gone;
  const auto client = socket.remote_endpoint(gone).address();
  if (gone) return;
  auto place = context_->connections->admit(client.to_string(), client.is_loopback());
  if (!place) return;
  if (!tls_) return serve_http(std::move(socket), context_, client.to_string(), std::move(place));
  tls_->enter(std::move(socket),
              [context = context_, place](tcp::socket inner, const std::string& address) {
                serve_http(std::move(inner), context, address, place);
              });
}

void HttpServer::accept() {
  acceptor_.async_accept([this](error_code error, tcp::socket socket) {
    if (error == boost::asio::error::operation_aborted) return;
    if (error == boost::asio::error::connection_aborted) return accept();  // by the client
    if (error) return recover();
    (void)guarded("a new connection", [&] { welcome(std::move(socket)); });
    accept();
  });
}

void HttpServer::recover() {
  context_->limit_counts->reached(Limit::kDescriptors);
  if (context_->connections->close_waiting()) return accept();
  if (reserve_.give()) {
    // Nothing can be closed, so the next client is turned away, in place of waiting for ever.
    error_code none_waits;
    acceptor_.non_blocking(true, none_waits);
    tcp::socket turned_away(acceptor_.get_executor());
    acceptor_.accept(turned_away, none_waits);
    turned_away.close(none_waits);
    reserve_.take();
  }
  pause_.expires_after(kPauseWithoutDescriptors);
  pause_.async_wait([this](error_code error) {
    if (!error && acceptor_.is_open()) accept();
  });
}

}  // namespace galilean::monitor
