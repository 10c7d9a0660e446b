// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <boost/asio/ip/tcp.hpp>
#include <boost/beast/http/message.hpp>
#include <boost/beast/http/string_body.hpp>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <utility>

#include "monitor/server/limits/connections.h"
#include "monitor/server/websocket/outbox.h"
#include "monitor/server/websocket/send_rounds.h"

namespace galilean::monitor {

/// The status codes of a close frame that the monitor sends (RFC 6455, section 7.4.1).
enum class CloseCode : std::uint16_t { kNormal = 1000, kPolicy = 1008, kInternalError = 1011 };

/// The server's side of one WebSocket. Both kinds of sessions stand on it, because Beast's stream
/// is compiled here once and takes longer than anything else in the monitor. Every `then` is called
/// later, on the io_context's one thread, and keeps its session alive until then. For use on that
/// thread.
class WebSocket {
 public:
  using Upgrade = boost::beast::http::request<boost::beast::http::string_body>;
  using Then = std::function<void(boost::system::error_code)>;

  /// `rounds` must outlive it. A message of more than `most_message_bytes` ends the connection, and
  /// so do more pings within a second than the limits of `place` allow, because Beast answers each.
  /// `place` is the connection's among all; a null pointer: it is not counted.
  WebSocket(boost::asio::ip::tcp::socket socket, SendRounds& rounds, std::size_t most_message_bytes,
            std::shared_ptr<Connections::Place> place = nullptr);
  /// Closes the connection, even if something is being written.
  ~WebSocket();
  /// Does `work`, which must not throw, when its turn comes among all clients' work.
  void in_turn(std::function<void()> work) const {
    if (!place_) return work();
    place_->in_turn(std::move(work));
  }
  WebSocket(const WebSocket&) = delete;
  WebSocket& operator=(const WebSocket&) = delete;

  /// Answers the client's handshake, and names `subprotocol` in the answer if it is not empty.
  void accept(const Upgrade& upgrade, std::string_view subprotocol, Then then);
  /// Reads the next message, in place of the last one. Where all connections together keep as much
  /// of their messages as they may, the connection ends.
  void read(Then then);
  /// Returns the message that was read, until the next read.
  [[nodiscard]] std::span<const std::uint8_t> message() const;
  [[nodiscard]] bool message_is_text() const;

  /// Sends one text message. `text` must live until `then`, which is called when the message has
  /// left. Requires: no other write is under way.
  void write(std::string_view text, Then then);
  /// Sends the frames of `outbox` from now on, for as long as the outbox lives. An empty pointer
  /// stops that.
  void send_from(std::weak_ptr<Outbox> outbox);
  /// Sends the outbox's waiting frames with the next round.
  void flush();

  /// Sends a close frame and waits for the client's.
  void close(CloseCode code, const std::string& reason, Then then);
  /// Ends the connection at once. What waits for it fails.
  void cut();

 private:
  void count_ping();
  void let_message_go();
  void read_piece(Then then);

  struct Stream;
  std::shared_ptr<Connections::Place> place_;
  std::chrono::steady_clock::time_point second_began_{};
  std::size_t pings_ = 0;  ///< since then
  std::unique_ptr<Stream> stream_;
};

}  // namespace galilean::monitor
