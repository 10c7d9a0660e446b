// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/server/websocket/web_socket.h"

#include <boost/asio/error.hpp>
#include <boost/beast/core/flat_buffer.hpp>
#include <boost/beast/http/field.hpp>
#include <boost/beast/websocket/stream.hpp>

#include "monitor/server/websocket/batching_socket.h"

namespace galilean::monitor {

namespace beast = boost::beast;
namespace http = beast::http;
namespace websocket = beast::websocket;
using error_code = boost::system::error_code;

namespace {

constexpr std::size_t kPieceBytes = std::size_t{64} << 10;

}  // namespace

struct WebSocket::Stream {
  websocket::stream<BatchingSocket> beast;
  beast::flat_buffer incoming = {};
};

WebSocket::WebSocket(boost::asio::ip::tcp::socket socket, SendRounds& rounds,
                     std::size_t most_message_bytes, std::shared_ptr<Connections::Place> place)
    : place_(std::move(place)),
      stream_(new Stream{websocket::stream<BatchingSocket>(std::move(socket), rounds)}) {
  stream_->beast.set_option(websocket::stream_base::timeout::suggested(beast::role_type::server));
  stream_->beast.read_message_max(most_message_bytes);
  stream_->beast.text(true);
  stream_->beast.control_callback([this](websocket::frame_type kind, beast::string_view) {
    if (kind == websocket::frame_type::ping) count_ping();
  });
}

void WebSocket::count_ping() {
  const auto now = std::chrono::steady_clock::now();
  if (now - second_began_ >= std::chrono::seconds(1)) {
    second_began_ = now;
    pings_ = 0;
  }
  const std::size_t most = place_ ? place_->limits().pings_per_s : ServerLimits().pings_per_s;
  if (++pings_ != most + 1) return;
  if (place_) place_->limit_counts().reached(Limit::kPings);
  // Beast is reading, and calls this meanwhile.
  stream_->beast.next_layer().close_later();
}

WebSocket::~WebSocket() {
  cut();
}

void WebSocket::cut() {
  stream_->beast.next_layer().close();
}

void WebSocket::accept(const Upgrade& upgrade, std::string_view subprotocol, Then then) {
  stream_->beast.set_option(websocket::stream_base::decorator(
      [named = std::string(subprotocol)](websocket::response_type& response) {
        response.set(http::field::server, "galilean");
        if (!named.empty()) response.set(http::field::sec_websocket_protocol, named);
      }));
  stream_->beast.async_accept(upgrade, std::move(then));
}

void WebSocket::read(Then then) {
  let_message_go();
  read_piece(std::move(then));
}

void WebSocket::let_message_go() {
  auto& incoming = stream_->incoming;
  incoming.consume(incoming.size());
  if (incoming.capacity() > kPieceBytes) incoming.shrink_to_fit();
  if (place_) place_->let_go();
}

/// A message is read in pieces, so that each of them is counted before there is room for the next.
void WebSocket::read_piece(Then then) {
  stream_->beast.async_read_some(
      stream_->incoming, kPieceBytes,
      [this, then = std::move(then)](error_code error, std::size_t bytes) mutable {
        if (error) return then(error);
        if (place_ && !place_->keep(bytes)) {
          cut();
          return then(boost::asio::error::no_buffer_space);
        }
        if (stream_->beast.is_message_done()) return then(error);
        read_piece(std::move(then));
      });
}

std::span<const std::uint8_t> WebSocket::message() const {
  const auto bytes = stream_->incoming.cdata();
  return {static_cast<const std::uint8_t*>(bytes.data()), bytes.size()};
}

bool WebSocket::message_is_text() const {
  return stream_->beast.got_text();
}

void WebSocket::write(std::string_view text, Then then) {
  stream_->beast.async_write(
      boost::asio::buffer(text),
      [then = std::move(then)](error_code error, std::size_t) { then(error); });
}

void WebSocket::send_from(std::weak_ptr<Outbox> outbox) {
  stream_->beast.next_layer().send_from(std::move(outbox));
}

void WebSocket::flush() {
  stream_->beast.next_layer().flush();
}

void WebSocket::close(CloseCode code, const std::string& reason, Then then) {
  stream_->beast.async_close({static_cast<websocket::close_code>(code), reason}, std::move(then));
}

}  // namespace galilean::monitor
