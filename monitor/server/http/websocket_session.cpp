// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/server/http/websocket_session.h"

#include "monitor/background/guarded.h"
#include "monitor/server/foxglove/subprotocol.h"
#include "monitor/server/websocket/web_socket.h"

namespace galilean::monitor {
namespace {

using Upgrade = WebSocket::Upgrade;
using error_code = boost::system::error_code;

/// Room for a push of the largest program, escaped as JSON.
constexpr std::size_t kMostMessageBytes = std::size_t{9} << 20;

class WebSocketSession final : public foxglove::Link,
                               public Revocable,
                               public std::enable_shared_from_this<WebSocketSession> {
 public:
  WebSocketSession(boost::asio::ip::tcp::socket socket, foxglove::Hub& hub, SendRounds& rounds,
                   Right right, OperatorId who, std::shared_ptr<Connections::Place> place)
      : socket_(std::move(socket), rounds, kMostMessageBytes, std::move(place)),
        hub_(hub),
        right_(right),
        who_(std::move(who)) {}

  void start(const Upgrade& upgrade) {
    const auto subprotocol = foxglove::subprotocol_for(upgrade);
    socket_.accept(
        upgrade, subprotocol,
        [self = shared_from_this(), understood = !subprotocol.empty()](error_code error) {
          if (error) return;
          if (understood)
            self->attempt([&] { self->begin(); });
          else
            self->close(foxglove::kNoSubprotocol);
          self->read();
        });
  }

  void flush() override { socket_.flush(); }

  void close(const std::string& reason) override { close_with(CloseCode::kPolicy, reason); }

  void revoke(const std::string& reason) override {
    client_.reset();
    close_with(CloseCode::kPolicy, reason);
  }

  void cut() override { socket_.cut(); }

 private:
  void close_with(CloseCode code, const std::string& reason) {
    socket_.send_from({});
    if (std::exchange(closing_, true)) return;
    socket_.close(code, reason, [self = shared_from_this()](error_code) {});
  }

  /// Runs `work`, and closes the connection if it throws, because it may have been done by half.
  template <class Work>
  void attempt(Work work) {
    if (!guarded("a client of /ws", work))
      close_with(CloseCode::kInternalError, "the monitor failed; its log says why");
  }

  void begin() {
    client_ = hub_.connect(*this, right_ == Right::kOperate, who_);
    socket_.send_from(client_->outbox_while_connected());
    flush();
  }

  void read() {
    socket_.read([self = shared_from_this()](error_code error) {
      if (error) return self->client_.reset();
      self->take_message();
    });
  }

  /// What an operator orders passes by all other clients' messages, which are taken in turn.
  void take_message() {
    const auto work = [self = shared_from_this()] {
      self->attempt([&] { self->receive(); });
      self->read();
    };
    if (right_ == Right::kOperate) return work();
    socket_.in_turn(work);
  }

  void receive() {
    if (!client_ || closing_) return;
    const auto message = socket_.message();
    if (socket_.message_is_text())
      client_->receive_text({reinterpret_cast<const char*>(message.data()), message.size()});
    else
      client_->receive_binary(message);
  }

  WebSocket socket_;
  foxglove::Hub& hub_;
  Right right_;
  OperatorId who_;
  std::unique_ptr<foxglove::Hub::Client> client_;
  bool closing_ = false;
};

}  // namespace

std::weak_ptr<Revocable> serve_websocket(boost::asio::ip::tcp::socket socket,
                                         const Upgrade& upgrade, foxglove::Hub& hub,
                                         SendRounds& rounds, Right right, const OperatorId& who,
                                         std::shared_ptr<Connections::Place> place) {
  const auto session = std::make_shared<WebSocketSession>(std::move(socket), hub, rounds, right,
                                                          who, std::move(place));
  session->start(upgrade);
  return session;
}

}  // namespace galilean::monitor
