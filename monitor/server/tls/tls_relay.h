// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/ssl/stream.hpp>
#include <boost/asio/steady_timer.hpp>
#include <chrono>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>

namespace galilean::monitor {

/// Carries bytes between a client that speaks TLS and a session that does not. The session gets one
/// socket of a pair; the other is the relay's. What one side sends waits in the other's buffers, so
/// that a slow reader holds its writer up through the relay. When the session closes its socket,
/// the client gets what was sent before, and TLS's own goodbye. It owns itself while anything is
/// under way.
class TlsRelay : public std::enable_shared_from_this<TlsRelay> {
 public:
  using tcp = boost::asio::ip::tcp;
  using Admit = std::function<void(tcp::socket socket, const std::string& address)>;

  /// `place` is given back when the handshake is over. `admit` is kept as long as the relay lives,
  /// so that what it holds, such as the connection's place among all, is free when the client is
  /// gone, and not only when the session is.
  TlsRelay(tcp::socket client, boost::asio::ssl::context& context, std::shared_ptr<void> place,
           Admit admit);

  void start();

 private:
  using error_code = boost::system::error_code;
  static constexpr std::size_t kPieceBytes = 16 << 10;  // as a record of TLS

  // Until the session has its socket.
  void look_at_first_byte();
  void tell_plain_client();
  void admit();
  [[nodiscard]] bool make_pair(tcp::socket& for_session);

  // Bytes.
  void read_client();
  void read_session();

  // The end.
  void close();
  void say_goodbye();
  void read_to_end();
  void cut();
  /// Cuts the connection unless `limit` or `no_limit` is called before.
  void limit(std::chrono::seconds most);
  void no_limit();

  boost::asio::ssl::stream<tcp::socket> client_;
  tcp::socket session_;
  boost::asio::steady_timer timer_;
  std::shared_ptr<void> place_;
  Admit admit_;
  std::string address_;
  std::array<std::uint8_t, kPieceBytes> from_client_{}, from_session_{};
  std::uint64_t limits_ =
      0;  ///< how often a limit was set or lifted; an earlier one does not count
  bool reads_client_ = false;
  bool closes_ = false;
};

}  // namespace galilean::monitor
