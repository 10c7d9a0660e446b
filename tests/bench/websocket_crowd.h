// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <chrono>
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace galilean::bench {

/// Many WebSocket clients on one thread. They cost as little as possible, so that the server is
/// measured and not its clients. They count frames by their headers, and keep only the first bytes
/// of each frame.
class WebSocketCrowd {
 public:
  /// How many bytes of a frame's payload are kept.
  static constexpr std::size_t kKept = 16;

  struct Frame {
    std::size_t client;
    std::uint8_t opcode;  ///< 1 text, 2 binary
    std::uint64_t size;
    std::span<const std::uint8_t> begin;  ///< at most kKept bytes
  };
  using OnFrame = std::function<void(const Frame&)>;
  using Clock = std::chrono::steady_clock;

  /// Errors: throws std::runtime_error if the server does not accept all clients.
  WebSocketCrowd(std::uint16_t port, const std::string& target, const std::string& subprotocol,
                 std::size_t clients);
  ~WebSocketCrowd();
  WebSocketCrowd(const WebSocketCrowd&) = delete;
  WebSocketCrowd& operator=(const WebSocketCrowd&) = delete;

  void send_text(std::size_t client, std::string_view text) { send(client, 0x81, text); }
  void send_binary(std::size_t client, std::string_view bytes) { send(client, 0x82, bytes); }
  /// Reads what has come. If nothing has come, waits up to `patience` for it.
  void read(std::chrono::milliseconds patience, const OnFrame& on_frame);
  /// From now on reads nothing of what comes to this client, whose connection stays.
  void stall(std::size_t client);
  [[nodiscard]] std::size_t size() const noexcept { return clients_.size(); }

 private:
  struct Client {
    int socket = -1;
    std::array<std::uint8_t, 14 + kKept> head{};
    std::size_t head_size = 0;
    std::uint64_t skip = 0;  ///< bytes of the frame's payload that are still to come and are not
                             ///< kept
  };

  void send(std::size_t client, std::uint8_t first_byte, std::string_view payload);
  void handshake(int socket, std::uint16_t port, const std::string& target,
                 const std::string& subprotocol);
  void parse(std::size_t client, std::span<const std::uint8_t> bytes, const OnFrame& on_frame);
  [[nodiscard]] std::size_t take_head(Client& client, std::span<const std::uint8_t> bytes) const;

  int epoll_ = -1;
  std::vector<Client> clients_;
  std::vector<std::uint8_t> buffer_;
};

}  // namespace galilean::bench
