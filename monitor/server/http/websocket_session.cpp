// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/server/http/websocket_session.h"

#include <boost/beast/core/flat_buffer.hpp>
#include <boost/beast/http/field.hpp>
#include <boost/beast/http/rfc7230.hpp>
#include <boost/beast/websocket/stream.hpp>

#include "monitor/background/guarded.h"
#include "monitor/server/websocket/batching_socket.h"

namespace galilean::monitor {
namespace {

namespace beast = boost::beast;
namespace http = beast::http;
namespace websocket = beast::websocket;
using Upgrade = http::request<http::string_body>;
using error_code = boost::system::error_code;

/// Room for a push of the largest program, escaped as JSON.
constexpr std::size_t kMostMessageBytes = 16 << 20;

/// Returns the first subprotocol that both sides speak, or an empty string.
std::string_view subprotocol_for(const Upgrade& upgrade) {
  http::token_list offered(upgrade[http::field::sec_websocket_protocol]);
  for (const auto ours : foxglove::kSubprotocols)
    if (offered.exists({ours.data(), ours.size()})) return ours;
  return {};
}

class WebSocketSession final : public foxglove::Link,
                               public std::enable_shared_from_this<WebSocketSession> {
 public:
  WebSocketSession(boost::asio::ip::tcp::socket socket, foxglove::Hub& hub, SendRounds& rounds,
                   Right right)
      : stream_(std::move(socket), rounds), hub_(hub), right_(right) {}
  ~WebSocketSession() override { stream_.next_layer().close(); }

  void start(const Upgrade& upgrade) {
    const auto subprotocol = subprotocol_for(upgrade);
    stream_.set_option(websocket::stream_base::timeout::suggested(beast::role_type::server));
    stream_.set_option(websocket::stream_base::decorator([subprotocol](auto& response) {
      response.set(http::field::server, "galilean");
      if (!subprotocol.empty())
        response.set(http::field::sec_websocket_protocol,
                     beast::string_view(subprotocol.data(), subprotocol.size()));
    }));
    stream_.read_message_max(kMostMessageBytes);
    stream_.async_accept(
        upgrade, [self = shared_from_this(), understood = !subprotocol.empty()](error_code error) {
          if (error) return;
          if (understood)
            self->attempt([&] { self->begin(); });
          else
            self->close("offer the subprotocol foxglove.sdk.v1 or foxglove.websocket.v1");
          self->read();
        });
  }

  void flush() override { stream_.next_layer().flush(); }

  void close(const std::string& reason) override {
    close_with(websocket::close_code::policy_error, reason);
  }

 private:
  void close_with(websocket::close_code code, const std::string& reason) {
    stream_.next_layer().send_from({});
    if (std::exchange(closing_, true)) return;
    stream_.async_close({code, reason}, [self = shared_from_this()](error_code) {});
  }

  /// Runs `work`, and closes the connection if it throws, because it may have been done by half.
  template <class Work>
  void attempt(Work work) {
    if (!guarded("a client of /ws", work))
      close_with(websocket::close_code::internal_error, "the monitor failed; its log says why");
  }

  void begin() {
    client_ = hub_.connect(*this, right_ == Right::kOperate);
    stream_.next_layer().send_from(client_->outbox_while_connected());
    flush();
  }

  void read() {
    stream_.async_read(incoming_, [self = shared_from_this()](error_code error, std::size_t) {
      if (error) return self->client_.reset();
      self->attempt([&] { self->receive(); });
      self->incoming_.consume(self->incoming_.size());
      self->read();
    });
  }

  void receive() {
    if (!client_ || closing_) return;
    const auto* bytes = static_cast<const std::uint8_t*>(incoming_.data().data());
    if (stream_.got_text())
      client_->receive_text({reinterpret_cast<const char*>(bytes), incoming_.size()});
    else
      client_->receive_binary({bytes, incoming_.size()});
  }

  websocket::stream<BatchingSocket> stream_;
  foxglove::Hub& hub_;
  Right right_;
  std::unique_ptr<foxglove::Hub::Client> client_;
  beast::flat_buffer incoming_;
  bool closing_ = false;
};

}  // namespace

void serve_websocket(boost::asio::ip::tcp::socket socket, Upgrade upgrade, foxglove::Hub& hub,
                     SendRounds& rounds, Right right) {
  std::make_shared<WebSocketSession>(std::move(socket), hub, rounds, right)->start(upgrade);
}

}  // namespace galilean::monitor
